#pragma once

#include <set>
#include <string>
#include <vector>

#include "libvehicle/project/suite_work.h"
#include "libvehicle/xml/file_source.h"

namespace vehicle {

/// One vehicle on one scenario, at one or several speeds, or all of a suite.
struct ValidationWork {
  SuiteWork cases;
  bool is_suite = false;
  /// A suite, or one vehicle and scenario at several speeds: one line for each case.
  [[nodiscard]] bool hasSeveral() const { return is_suite || cases.cases.size() > 1; }
};

/// What is validated, by its files.
struct ValidationFiles {
  std::string vehicle_or_suite;
  std::string scenario;               // "" with a suite
  std::vector<std::string> settings;  // "ADDRESS=VALUE", in place of values of the files
};

/// Reads a vehicle and a scenario, or a suite alone with all files that it names.
/// @throws InvalidInput           a file is wrong
/// @throws std::invalid_argument  a scenario beside a suite, or none beside a vehicle; a setting that is wrong
[[nodiscard]] ValidationWork readValidationWork(const ValidationFiles& named, const ValidationChoice& choice,
                                                FileSource& files);

/// What runs in any of the cases.
struct PlannedRuns {
  std::set<std::string> methods;
  bool shares = false;  // some run among threads where the choice omits none of them
};
/// Cost: the eigenvalues of every vehicle.
[[nodiscard]] PlannedRuns plannedRuns(const SuiteWork& work);

/// Validates case by case; one that is ended early is the last.
[[nodiscard]] std::vector<ValidationReport> validateCases(const SuiteWork& work,
                                                          const ValidationProgress& progress = {});

}  // namespace vehicle
