#pragma once

#include <string>
#include <vector>

#include "libvehicle/definition/suite.h"
#include "libvehicle/diagnostics/warning.h"
#include "libvehicle/project/settings.h"
#include "libvehicle/validation/validation.h"
#include "libvehicle/xml/file_source.h"

namespace vehicle {

/// A suite with the files that it names, and the cases that it crosses them to.
struct SuiteWork {
  Suite suite;
  std::vector<Vehicle> vehicles;    // in the suite's order
  std::vector<Scenario> scenarios;  // in the suite's order
  std::vector<ValidationCase> cases;
  ValidationChoice choice;
};

/// The vehicle of that case under the gravity of its scenario.
[[nodiscard]] CompiledModel modelOf(const SuiteWork& work, const ValidationCase& of);

/// Reads a suite and all files that it names. Problems of all of them are reported together: unknown forms and methods,
/// vehicles that cannot run over a scenario at one of the speeds, cases whose histories would not fit in memory.
/// @param choice    forms and methods of the command line take the place of the suite's; its speeds that of all
/// @param settings  are applied to each vehicle and scenario that has what they name; the caller asks requireRight()
[[nodiscard]] Outcome<SuiteWork> readSuiteWork(const std::string& file, const ValidationChoice& choice,
                                               FileSource& files, Settings& settings);
[[nodiscard]] Outcome<SuiteWork> readSuiteWork(const std::string& file, const ValidationChoice& choice,
                                               FileSource& files);

/// Vehicles of which none of the chosen forms and methods makes two runs that could be compared; one warning for the
/// whole suite if that is so for all of them.
[[nodiscard]] Warnings unjudgedOf(const SuiteWork& work);

}  // namespace vehicle
