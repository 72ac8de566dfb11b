#include "libvehicle/xml/reader.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/xml/attribute_value.h"
#include "libvehicle/xml/document.h"
#include "libvehicle/xml/message_text.h"
#include "libvehicle/xml/named_file.h"
#include "libvehicle/xml/part_reader.h"
#include "libvehicle/xml/text_guard.h"

namespace vehicle {

namespace {

std::optional<FileKind> kindNamed(std::string_view root_name) {
  for (const FileKind kind : allFileKinds()) {
    if (schemaOf(kind).name == root_name) return kind;
  }
  return std::nullopt;
}

Problem unknownRoot(const tinyxml2::XMLElement& root, const std::string& file_name) {
  std::vector<std::string> names;
  for (const FileKind kind : allFileKinds()) names.push_back(schemaOf(kind).name);
  const auto nearest = suggestion(root.Value(), names);
  return {{file_name, root.GetLineNum()},
          "",
          fmt::format("the root element <{}> is unknown", shown(root.Value())),
          nearest ? fmt::format("did you mean <{}>?", *nearest)
                  : fmt::format("a file holds one of <{}>", joined(names, ">, <"))};
}

/// The first problems of very many: who sees thousands has opened the wrong file.
ProblemList firstOf(const ProblemList& all) {
  if (all.size() <= kMostProblems + 1) return all;
  ProblemList first;
  for (std::size_t i = 0; i < kMostProblems; ++i) first.add(all[i]);
  first.add(tooMany(all[kMostProblems].place));
  return first;
}

template <class Definition>
Outcome<Definition> readDefinition(std::string_view text, const std::string& file_name, FileKind kind) {
  Outcome<Definition> outcome;
  const Document document = parseDocument(text, file_name);
  outcome.problems = document.problems;
  if (document.root == nullptr) return outcome;

  const ElementRow& schema = schemaOf(kind);
  const std::optional<FileKind> found = kindNamed(document.root->Value());
  if (!found) {
    outcome.problems.add(unknownRoot(*document.root, file_name));
    return outcome;
  }
  if (*found != kind) {
    outcome.problems.add({{file_name, document.root->GetLineNum()},
                          "",
                          fmt::format("the file holds a <{}>", document.root->Value()),
                          fmt::format("a <{}> is expected here", schema.name)});
    return outcome;
  }

  Definition definition;
  PartReader reader(file_name);
  reader.read(*document.root, schema, &definition);
  outcome.problems = reader.takeProblems();
  if (reader.isComplete()) outcome.problems.append(check(definition));
  outcome.problems.sortByPlace();
  outcome.problems = firstOf(outcome.problems);
  if (outcome.problems.empty()) outcome.value = std::move(definition);
  return outcome;
}

template <class Definition>
Outcome<Definition> readFile(const std::string& path, FileKind kind, FileSource& files) {
  const Outcome<std::string>& text = files.text(path);
  if (!text.value) return {std::nullopt, text.problems};
  return readDefinition<Definition>(*text.value, path, kind);
}

/// Fills in what the files of a train's vehicles hold; a file that is named twice is reported once.
void readVehiclesOf(Train& train, FileSource& files, ProblemList& problems) {
  std::map<std::string, Outcome<Vehicle>> known;
  for (TrainVehicle& each : train.vehicles) {
    const std::string path = resolvePath(each.origin.file, each.file);
    auto found = known.find(path);
    if (found == known.end()) {
      const ProblemList missing = checkNamedFile("train", {each.file, each.origin}, {FileKind::kVehicle}, files);
      problems.append(missing);
      if (!missing.empty()) continue;
      found = known.emplace(path, readFile<Vehicle>(path, FileKind::kVehicle, files)).first;
      problems.append(found->second.problems);
    }
    if (found->second.value) each.vehicle = *found->second.value;
  }
}

}  // namespace

Outcome<Vehicle> readVehicleText(std::string_view text, const std::string& file_name) {
  return readDefinition<Vehicle>(text, file_name, FileKind::kVehicle);
}

Outcome<Train> readTrainText(std::string_view text, const std::string& file_name) {
  return readDefinition<Train>(text, file_name, FileKind::kTrain);
}

Outcome<Scenario> readScenarioText(std::string_view text, const std::string& file_name) {
  return readDefinition<Scenario>(text, file_name, FileKind::kScenario);
}

Outcome<Suite> readSuiteText(std::string_view text, const std::string& file_name) {
  return readDefinition<Suite>(text, file_name, FileKind::kSuite);
}

Outcome<Study> readStudyText(std::string_view text, const std::string& file_name) {
  return readDefinition<Study>(text, file_name, FileKind::kStudy);
}

Outcome<Vehicle> readVehicle(const std::string& path, FileSource& files) {
  if (kindOf(path, files).value != FileKind::kTrain) return readFile<Vehicle>(path, FileKind::kVehicle, files);
  Outcome<Train> train = readTrain(path, files);
  if (!train.value) return {std::nullopt, std::move(train.problems)};
  return {assembled(*train.value), {}};
}

Outcome<Train> readTrain(const std::string& path, FileSource& files) {
  Outcome<Train> outcome = readFile<Train>(path, FileKind::kTrain, files);
  if (!outcome.value) return outcome;
  readVehiclesOf(*outcome.value, files, outcome.problems);
  if (outcome.problems.empty()) outcome.problems = check(*outcome.value);
  outcome.problems = firstOf(outcome.problems);
  if (!outcome.problems.empty()) outcome.value.reset();
  return outcome;
}

Outcome<Scenario> readScenario(const std::string& path, FileSource& files) {
  return readFile<Scenario>(path, FileKind::kScenario, files);
}

Outcome<Suite> readSuite(const std::string& path, FileSource& files) {
  return readFile<Suite>(path, FileKind::kSuite, files);
}

Outcome<Study> readStudy(const std::string& path, FileSource& files) {
  return readFile<Study>(path, FileKind::kStudy, files);
}

Outcome<FileKind> kindOf(const std::string& path, FileSource& files) {
  const Outcome<std::string>& text = files.text(path);
  if (!text.value) return {std::nullopt, text.problems};
  Document document = parseDocument(*text.value, path);
  if (document.root == nullptr) return {std::nullopt, std::move(document.problems)};
  Outcome<FileKind> outcome;
  outcome.value = kindNamed(document.root->Value());
  if (!outcome.value) outcome.problems.add(unknownRoot(*document.root, path));
  return outcome;
}

Outcome<Vehicle> readVehicle(const std::string& path) {
  FileSource disk;
  return readVehicle(path, disk);
}

Outcome<Train> readTrain(const std::string& path) {
  FileSource disk;
  return readTrain(path, disk);
}

Outcome<Scenario> readScenario(const std::string& path) {
  FileSource disk;
  return readScenario(path, disk);
}

Outcome<Suite> readSuite(const std::string& path) {
  FileSource disk;
  return readSuite(path, disk);
}

Outcome<Study> readStudy(const std::string& path) {
  FileSource disk;
  return readStudy(path, disk);
}

Outcome<FileKind> kindOf(const std::string& path) {
  FileSource disk;
  return kindOf(path, disk);
}

}  // namespace vehicle
