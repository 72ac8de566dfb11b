#pragma once

#include <string>
#include <vector>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/model/compiled_model.h"
#include "libvehicle/project/settings.h"
#include "libvehicle/storage/run_record.h"
#include "libvehicle/xml/file_source.h"

namespace vehicle {

/// A vehicle, compiled, and what it meets, with the texts that they were read from.
struct Model {
  CompiledModel vehicle;  // under the scenario's gravity
  Scenario scenario;
  std::vector<InputFile> inputs;  // vehicle (or train), scenario, vehicles of the train; named by their paths
  std::vector<Setting> settings;  // that take the place of values in them
};

/// Reads both; the problems of both files are reported together, then what the scenario asks of this vehicle.
/// @param settings  are applied to both
/// @throws InvalidInput           a file is wrong
/// @throws std::invalid_argument  a setting is wrong
[[nodiscard]] Model readModel(const std::string& vehicle_file, const std::string& scenario_file, FileSource& files,
                              Settings settings = {});

}  // namespace vehicle
