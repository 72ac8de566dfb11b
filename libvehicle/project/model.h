#pragma once

#include <string>
#include <vector>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/vehicle.h"
#include "libvehicle/storage/output_guard.h"
#include "libvehicle/storage/run_record.h"
#include "libvehicle/xml/file_source.h"

namespace vehicle {

/// A vehicle and what it meets, with the texts that they were read from.
struct Model {
  Vehicle vehicle;
  Scenario scenario;
  std::vector<InputFile> inputs;  // vehicle (or train), scenario, vehicles of the train; named by their paths
};

/// Reads both; the problems of both files are reported together, then what the scenario asks of this vehicle.
/// @throws InvalidInput
[[nodiscard]] Model readModel(const std::string& vehicle_file, const std::string& scenario_file, FileSource& files);

/// Every file that the model was read from.
void protectInputs(OutputGuard& guard, const Model& model);

}  // namespace vehicle
