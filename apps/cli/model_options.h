#pragma once

#include <string>
#include <vector>

#include "apps/cli/cli11.h"
#include "libvehicle/project/model.h"
#include "libvehicle/report/document/document.h"

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
/// The document with a fact for each setting behind those that are there.
[[nodiscard]] report::Document withSettings(report::Document document, const std::vector<Setting>& settings);

/// Reads the vehicle alone and compiles it.
/// @param gravity  [m/s^2]
/// @throws InvalidInput, std::invalid_argument  a file, a setting is wrong
[[nodiscard]] CompiledModel readVehicleOf(const ModelFiles& files, double gravity);
/// Reads both, with the texts that they are made of.
/// @throws InvalidInput, std::invalid_argument
[[nodiscard]] Model readModel(const ModelFiles& files);

}  // namespace vehicle::cli
