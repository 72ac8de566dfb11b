#include "apps/cli/model_options.h"

#include <utility>

#include "apps/cli/options.h"
#include "libvehicle/xml/reader.h"

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
  Outcome<Vehicle> vehicle = readVehicle(files.vehicle);
  Outcome<Scenario> scenario = readScenario(files.scenario);
  ProblemList problems = vehicle.problems;
  problems.append(scenario.problems);
  if (problems.empty()) problems.append(check(*scenario.value, *vehicle.value));
  if (!problems.empty()) throw InvalidInput(std::move(problems));
  return {std::move(*vehicle.value), std::move(*scenario.value)};
}

}  // namespace vehicle::cli
