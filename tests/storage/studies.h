#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "libvehicle/storage/study_database.h"
#include "tests/support/test_folder.h"

// A study whose numbers follow from the design's id, so that what comes back can be judged without a second copy.
namespace vehicle::test {

inline StudyRecord smallStudy(std::uint64_t designs = 1000) {
  StudyRecord record;
  record.program = "vehicle 0.1.0";
  record.inputs = {{"study.xml", "<study>\n  <plan size=\"1000\"/>\n</study>\n"}, {"coach.xml", "<vehicle/>\n"}};
  record.parameters = {{"carbody.mass", "kg"}, {"primary.stiffness_z", "N/m"}};
  record.metrics = {
      {"carbody.az.rms @ 80 km/h", "m/s^2"}, {"carbody.az.rms @ 120 km/h", "m/s^2"}, {"static, load", "N"}};
  record.designs = designs;
  return record;
}

inline std::vector<double> parametersOfDesign(std::uint64_t id, std::size_t count = 2) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(1.0 / static_cast<double>(3 * id + i + 1));
  return values;
}

inline std::vector<double> metricsOfDesign(std::uint64_t id, std::size_t count = 3) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(static_cast<double>(id) + 0.1 * static_cast<double>(i));
  return values;
}

/// Every seventh design has failed.
inline bool hasFailed(std::uint64_t id) { return id % 7 == 3; }

inline void addDesign(DesignBatch& batch, std::uint64_t id) {
  if (hasFailed(id)) {
    std::string message = "no steady state at 80 km/h, \"";
    message.append(std::to_string(id)).append("\"");
    batch.addFailed(id, parametersOfDesign(id, batch.parameters()), std::move(message));
  } else {
    batch.add(id, parametersOfDesign(id, batch.parameters()), metricsOfDesign(id, batch.metrics()));
  }
}

inline DesignBatch batchOf(const StudyRecord& record, std::uint64_t first, std::uint64_t end) {
  DesignBatch batch(record.parameters.size(), record.metrics.size());
  for (std::uint64_t id = first; id < end; ++id) addDesign(batch, id);
  return batch;
}

/// What a call says when it refuses, without the folder's name.
inline std::string refusalOf(const TestFolder& folder, const std::function<void()>& call) {
  std::string text = "no refusal";
  try {
    call();
  } catch (const std::exception& error) {
    text = error.what();
  }
  const std::string root = folder.path("");
  for (std::size_t at = text.find(root); at != std::string::npos; at = text.find(root)) text.erase(at, root.size());
  return text;
}

}  // namespace vehicle::test
