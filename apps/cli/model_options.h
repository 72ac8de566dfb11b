#pragma once

#include <string>

#include "apps/cli/cli11.h"
#include "libvehicle/project/model.h"

namespace vehicle::cli {

/// VEHICLE, and SCENARIO after it where a command runs something.
struct ModelFiles {
  std::string vehicle;
  std::string scenario;
};
void addVehicleFile(CLI::App& command, ModelFiles& files);
void addScenarioFile(CLI::App& command, ModelFiles& files);

/// Gravity of a command without scenario [m/s^2].
void addGravity(CLI::App& command, double& gravity);

/// Reads both, with the texts that they are made of.
/// @throws InvalidInput
[[nodiscard]] Model readModel(const ModelFiles& files);

}  // namespace vehicle::cli
