#include "libvehicle/project/suite_work.h"

#include <utility>

#include "libvehicle/project/named_files.h"
#include "libvehicle/project/suite_check.h"
#include "libvehicle/xml/reader.h"

namespace vehicle {

namespace {

std::vector<ValidationCase> atSpeeds(const std::vector<double>& speeds, const std::vector<ValidationCase>& cases) {
  std::vector<ValidationCase> all;
  for (ValidationCase each : cases) {
    for (const double speed : speeds) {
      each.speed = speed;
      all.push_back(each);
    }
  }
  return all;
}

}  // namespace

CompiledModel modelOf(const SuiteWork& work, const ValidationCase& of) {
  return compileChecked(work.vehicles[of.vehicle], work.scenarios[of.scenario].gravity);
}

Outcome<SuiteWork> readSuiteWork(const std::string& file, const ValidationChoice& choice, FileSource& files) {
  Settings none;
  return readSuiteWork(file, choice, files, none);
}

Outcome<SuiteWork> readSuiteWork(const std::string& file, const ValidationChoice& choice, FileSource& files,
                                 Settings& settings) {
  Outcome<Suite> suite = draftSuite(file, files);
  if (!suite.value) return {std::nullopt, std::move(suite.problems)};

  SuiteWork work;
  NamedFiles named("suite", files, settings);
  for (const FileReference& each : suite.value->vehicles) {
    if (std::optional<Vehicle> vehicle = named.vehicle(each)) work.vehicles.push_back(std::move(*vehicle));
  }
  for (const FileReference& each : suite.value->scenarios) {
    if (std::optional<Scenario> scenario = named.scenario(each)) work.scenarios.push_back(std::move(*scenario));
  }
  if (!suite.value->speeds.empty()) {
    settings.refuse("speed", "has no effect: the suite gives the speeds itself", "omit it, or give --speed");
  }
  ProblemList problems = suite.problems;
  problems.append(named.problems());
  problems.append(checkNames(*suite.value));
  if (problems.empty()) {
    if (!choice.speeds.empty()) suite.value->speeds.clear();
    work.suite = std::move(*suite.value);
    work.cases = casesOf(work.suite);
    if (!choice.speeds.empty()) work.cases = atSpeeds(choice.speeds, work.cases);
    work.choice = choiceOf(work.suite, choice);
    problems = checkCases(work);
  }
  problems.sortByPlace();
  if (!problems.empty()) return {std::nullopt, std::move(problems)};
  return {std::move(work), {}};
}

}  // namespace vehicle
