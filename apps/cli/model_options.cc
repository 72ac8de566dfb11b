#include "apps/cli/model_options.h"

#include <CLI/App.hpp>

#include "apps/cli/options.h"

namespace vehicle::cli {

void addVehicleFile(CLI::App& command, ModelFiles& files) {
  command.add_option("vehicle", files.vehicle, "vehicle or train file, e.g. models/vehicles/al-oraiqat-2017.xml")
      ->type_name("VEHICLE")
      ->required();
}

void addScenarioFile(CLI::App& command, ModelFiles& files) {
  command.add_option("scenario", files.scenario, "scenario file, e.g. models/scenarios/paper-20mps.xml")
      ->type_name("SCENARIO")
      ->required();
}

void addGravity(CLI::App& command, double& gravity) {
  addQuantity(command, "--gravity", Dimension::kAcceleration, "for the static loads   (default: \"9.81 m/s^2\")",
              [&gravity](double value) { gravity = value; });
}

Model readModel(const ModelFiles& files) {
  FileSource disk;
  return vehicle::readModel(files.vehicle, files.scenario, disk);
}

}  // namespace vehicle::cli
