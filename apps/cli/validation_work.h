#pragma once

#include <string>
#include <vector>

#include "apps/cli/model_options.h"
#include "libvehicle/validation/validation.h"

namespace vehicle::cli {

/// What `validate` has to do: one case, or all of a suite.
struct ValidationWork {
  std::vector<Vehicle> vehicles;
  std::vector<Scenario> scenarios;
  std::vector<ValidationCase> cases;
  ValidationChoice choice;
  bool is_suite = false;
};

/// Reads VEHICLE and SCENARIO, or a suite alone and all files that it names.
/// @throws InvalidInput           problems of all files together
/// @throws std::invalid_argument  a suite with a scenario, a vehicle without one
[[nodiscard]] ValidationWork readWork(const ModelFiles& files, const ValidationChoice& choice);

}  // namespace vehicle::cli
