#include "libvehicle/xml/schema.h"

#include <fmt/format.h>

#include "libvehicle/xml/schema_files.h"

namespace vehicle {

const AttributeRow* ElementRow::attribute(std::string_view attribute_name) const {
  for (const AttributeRow& row : attributes) {
    if (row.name == attribute_name) return &row;
  }
  return nullptr;
}

const ElementRow* ElementRow::child(std::string_view element_name) const {
  for (const ElementRow& row : children) {
    if (row.name == element_name) return &row;
  }
  return nullptr;
}

const ElementRow& schemaOf(FileKind kind) {
  static const ElementRow kVehicle = schema::vehicleRow();
  static const ElementRow kTrain = schema::trainRow();
  static const ElementRow kScenario = schema::scenarioRow();
  static const ElementRow kSuite = schema::suiteRow();
  static const ElementRow kStudy = schema::studyRow();
  switch (kind) {
    case FileKind::kTrain:
      return kTrain;
    case FileKind::kScenario:
      return kScenario;
    case FileKind::kSuite:
      return kSuite;
    case FileKind::kStudy:
      return kStudy;
    case FileKind::kVehicle:
      break;
  }
  return kVehicle;
}

const std::vector<FileKind>& allFileKinds() {
  static const std::vector<FileKind> kKinds = {FileKind::kVehicle, FileKind::kTrain, FileKind::kScenario,
                                              FileKind::kSuite, FileKind::kStudy};
  return kKinds;
}

std::string rangeOf(const AttributeRow& row) {
  if (row.kind == ValueKind::kInteger) return fmt::format("{} to {}", row.least, row.most);
  if (row.kind != ValueKind::kQuantity || row.sign == Sign::kAny) return "";
  return row.sign == Sign::kPositive ? "> 0" : ">= 0";
}

std::string exampleOf(const AttributeRow& row, const ElementRow& element) {
  const std::string begin = fmt::format(" {}=\"", row.name);
  const std::size_t at = element.example.find(begin);
  if (at != std::string::npos) {
    return element.example.substr(at + 1, element.example.find('"', at + begin.size()) - at);
  }
  return fmt::format("{}=\"{}\"", row.name,
                     row.kind == ValueKind::kQuantity ? describe(row.dimension).example : row.choices[0]);
}

}  // namespace vehicle
