#include "libvehicle/project/check_file.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "libvehicle/model/rest.h"
#include "libvehicle/model/topology.h"
#include "libvehicle/project/study_work.h"
#include "libvehicle/project/suite_work.h"
#include "libvehicle/project/together.h"
#include "libvehicle/simulate/file_warnings.h"
#include "libvehicle/study/study_warnings.h"
#include "libvehicle/xml/reader.h"

namespace vehicle {

namespace {

// Of the commands that take a vehicle alone; a scenario may say otherwise.
constexpr double kGravity = 9.81;  // [m/s^2]

/// What statics finds in the parts with which nothing else is wrong.
ProblemList restProblems(const Vehicle& draft) {
  try {
    static_cast<void>(restOf(soundTopologyOf(draft), kGravity));
  } catch (const InvalidInput& wrong) {
    return wrong.problems();
  }
  return {};
}

CheckedFile checkVehicle(const std::string& path, FileKind kind, FileSource& files, Settings& settings) {
  CheckedFile checked;
  Outcome<Vehicle> read = readVehicle(path, files);
  checked.problems = std::move(read.problems);
  std::vector<Vehicle> drafts = draftVehicles(path, files);
  if (read.value && !settings.empty()) {
    settings.apply(*read.value);
    drafts = {*read.value};
  }
  for (const Vehicle& draft : drafts) checked.problems.append(restProblems(draft));
  checked.problems.sortByPlace();
  checked.vehicle = std::move(read.value);
  if (!checked.problems.empty()) {
    // The parts of a train have their names only when it is assembled.
    if (kind == FileKind::kVehicle && !drafts.empty()) checked.vehicle = std::move(drafts.front());
    return checked;
  }
  checked.warnings = fileWarnings(compileChecked(*checked.vehicle, kGravity));
  checked.notes = notesOn(*checked.vehicle);
  return checked;
}

CheckedFile checkScenario(const std::string& path, FileSource& files, Settings& settings) {
  CheckedFile checked;
  Outcome<Scenario> draft = draftScenario(path, files);
  checked.problems = std::move(draft.problems);
  checked.scenario = std::move(draft.value);
  if (!checked.problems.empty()) return checked;
  settings.apply(*checked.scenario);
  checked.notes = notesOn(*checked.scenario);
  return checked;
}

CheckedFile checkSuite(const std::string& path, FileSource& files, Settings& settings) {
  CheckedFile checked;
  const Outcome<SuiteWork> work = readSuiteWork(path, {}, files, settings);
  checked.problems = work.problems;
  if (!work.value) return checked;
  checked.warnings = unjudgedOf(*work.value);
  for (const Vehicle& each : work.value->vehicles) {
    const Warnings found = fileWarnings(compileChecked(each, kGravity));
    checked.warnings.insert(checked.warnings.end(), found.begin(), found.end());
  }
  return checked;
}

CheckedFile checkStudy(const std::string& path, FileSource& files, Settings& settings) {
  CheckedFile checked;
  const Outcome<StudyWork> work = readStudyWork(path, files, settings);
  checked.problems = work.value ? checkBeforeFirstDesign(*work.value, path) : work.problems;
  if (checked.problems.empty()) checked.warnings = warningsBefore(work.value->inputs);
  return checked;
}

}  // namespace

CheckedFile checkFile(const std::string& path, FileSource& files) {
  Settings none;
  return checkFile(path, files, none);
}

CheckedFile checkFile(const std::string& path, FileSource& files, Settings& settings) {
  const Outcome<FileKind> kind = kindOf(path, files);
  if (!kind.value) return {.problems = kind.problems};
  switch (*kind.value) {
    case FileKind::kVehicle:
    case FileKind::kTrain:
      return checkVehicle(path, *kind.value, files, settings);
    case FileKind::kScenario:
      return checkScenario(path, files, settings);
    case FileKind::kSuite:
      return checkSuite(path, files, settings);
    case FileKind::kStudy:
      return checkStudy(path, files, settings);
  }
  return {};
}

ProblemList checkPair(const CheckedFile& vehicle, const CheckedFile& scenario) {
  if (!vehicle.vehicle || !scenario.scenario) return {};
  if (!vehicle.problems.empty() || !scenario.problems.empty()) return check(*scenario.scenario, *vehicle.vehicle);
  return checkTogether(*vehicle.vehicle, *scenario.scenario, scenario.scenario->run.speed);
}

std::vector<NamedCheck> checkFiles(const std::vector<std::string>& paths, FileSource& files, Settings& settings) {
  std::vector<NamedCheck> all;
  for (const std::string& path : paths) all.push_back({path, checkFile(path, files, settings)});
  // A file that could not be read may be the one that has the name.
  const bool is_read =
      std::all_of(all.begin(), all.end(), [](const NamedCheck& each) { return each.found.problems.empty(); });
  if (is_read) settings.requireRight();
  for (NamedCheck& scenario : all) {
    ProblemList found;
    for (const NamedCheck& vehicle : all) {
      // Several vehicles may show the same mistake of a scenario.
      for (const Problem& each : checkPair(vehicle.found, scenario.found)) found.addNew(each);
    }
    scenario.found.problems.append(found);
  }
  return all;
}

}  // namespace vehicle
