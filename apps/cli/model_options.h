#pragma once

#include <string>
#include <vector>

#include "apps/cli/cli11.h"
#include "apps/cli/document.h"
#include "libvehicle/project/model.h"

namespace vehicle::cli {

/// VEHICLE, and SCENARIO after it where a command runs something.
struct ModelFiles {
  std::string vehicle;
  std::string scenario;
  std::vector<std::string> settings;  // --set
};
void addVehicleFile(CLI::App& command, ModelFiles& files);
void addScenarioFile(CLI::App& command, ModelFiles& files);

/// Gravity of a command without scenario [m/s^2].
void addGravity(CLI::App& command, double& gravity);

/// --set, any number of times.
/// @param remark  what is applied to what, where that needs words
void addSet(CLI::App& command, std::vector<std::string>& settings, const std::string& remark = "");
/// @throws std::invalid_argument  --speed and --set speed are both given
void requireOneSpeed(const CLI::App& command, const std::vector<Setting>& settings);
/// A fact for each setting, after those that are there.
void addSettings(const std::vector<Setting>& settings, Document& document);

/// Reads the vehicle alone.
/// @throws InvalidInput, std::invalid_argument  a file, a setting is wrong
[[nodiscard]] Vehicle readVehicleOf(const ModelFiles& files);
/// Reads both, with the texts that they are made of.
/// @throws InvalidInput, std::invalid_argument
[[nodiscard]] Model readModel(const ModelFiles& files);

}  // namespace vehicle::cli
