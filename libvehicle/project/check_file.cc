#include "libvehicle/project/check_file.h"

#include <utility>

#include "libvehicle/project/study_work.h"
#include "libvehicle/project/suite_work.h"
#include "libvehicle/project/together.h"
#include "libvehicle/xml/reader.h"

namespace vehicle {

namespace {

CheckedFile checkVehicle(const std::string& path, FileSource& files) {
  CheckedFile checked;
  Outcome<Vehicle> read = readVehicle(path, files);
  checked.problems = std::move(read.problems);
  if (!read.value) return checked;
  // Of the commands that take a vehicle alone; a scenario may say otherwise.
  constexpr double kGravity = 9.81;  // [m/s^2]
  checked.problems = checkRest(*read.value, kGravity);
  if (checked.problems.empty()) checked.vehicle = std::move(read.value);
  return checked;
}

CheckedFile checkScenario(const std::string& path, FileSource& files) {
  CheckedFile checked;
  Outcome<Scenario> read = readScenario(path, files);
  checked.problems = std::move(read.problems);
  checked.scenario = std::move(read.value);
  return checked;
}

CheckedFile checkSuite(const std::string& path, FileSource& files) {
  CheckedFile checked;
  const Outcome<SuiteWork> work = readSuiteWork(path, {}, files);
  checked.problems = work.problems;
  if (work.value) checked.warnings = unjudgedOf(*work.value);
  return checked;
}

CheckedFile checkStudy(const std::string& path, FileSource& files) {
  CheckedFile checked;
  const Outcome<StudyWork> work = readStudyWork(path, files);
  checked.problems = work.value ? checkBeforeFirstDesign(*work.value, path) : work.problems;
  return checked;
}

}  // namespace

CheckedFile checkFile(const std::string& path, FileSource& files) {
  const Outcome<FileKind> kind = kindOf(path, files);
  if (!kind.value) return {kind.problems, {}, {}, {}};
  switch (*kind.value) {
    case FileKind::kVehicle:
    case FileKind::kTrain:
      return checkVehicle(path, files);
    case FileKind::kScenario:
      return checkScenario(path, files);
    case FileKind::kSuite:
      return checkSuite(path, files);
    case FileKind::kStudy:
      return checkStudy(path, files);
  }
  return {};
}

}  // namespace vehicle
