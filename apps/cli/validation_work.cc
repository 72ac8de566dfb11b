#include "apps/cli/validation_work.h"

#include <stdexcept>
#include <utility>

#include "libvehicle/xml/reader.h"

namespace vehicle::cli {
namespace {

/// The files that a suite names; the problems of all of them are told together.
ValidationWork readSuiteFiles(const std::string& file, const ValidationChoice& choice) {
  const Suite suite = readSuite(file).orThrow();
  ValidationWork work{{}, {}, casesOf(suite), choiceOf(suite, choice), true};
  ProblemList problems;
  for (const FileReference& named : suite.vehicles) {
    Outcome<Vehicle> read = readVehicle(resolvePath(file, named.file));
    problems.append(read.problems);
    if (read.value) work.vehicles.push_back(std::move(*read.value));
  }
  for (const FileReference& named : suite.scenarios) {
    Outcome<Scenario> read = readScenario(resolvePath(file, named.file));
    problems.append(read.problems);
    if (read.value) work.scenarios.push_back(std::move(*read.value));
  }
  if (!problems.empty()) throw InvalidInput(std::move(problems));
  return work;
}

}  // namespace

ValidationWork readWork(const ModelFiles& files, const ValidationChoice& choice) {
  const FileKind kind = kindOf(files.vehicle).orThrow();
  const bool is_suite = kind == FileKind::kSuite;
  if (is_suite && !files.scenario.empty())
    throw std::invalid_argument("a suite names its scenarios itself; leave out SCENARIO");
  if (!is_suite && files.scenario.empty())
    throw std::invalid_argument("SCENARIO is missing, or a suite instead of VEHICLE");
  if (is_suite) return readSuiteFiles(files.vehicle, choice);
  Model model = readModel(files);
  return {{std::move(model.vehicle)}, {std::move(model.scenario)}, {{0, 0, choice.run.speed}}, choice, false};
}

}  // namespace vehicle::cli
