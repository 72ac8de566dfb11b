#include "apps/cli/model_options.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <CLI/App.hpp>

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

void addSet(CLI::App& command, std::vector<std::string>& settings, const std::string& remark) {
  command
      .add_option("--set", settings,
                  "a number in place of the file's, e.g. \"secondary.stiffness_z=600 kN/m\"; names as in studies: "
                  "carbody.mass, front.x, of a train coach_2.carbody.mass, of a scenario scenario.gravity or "
                  "scenario.NAME.amplitude; may be given several times" +
                      remark + "   (default: none)")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void requireOneSpeed(const CLI::App& command, const std::vector<Setting>& settings) {
  const bool is_set =
      std::any_of(settings.begin(), settings.end(), [](const Setting& each) { return each.address == "speed"; });
  if (!is_set || command.count("--speed") == 0) return;
  throw std::invalid_argument("--speed and --set speed both give the running speed; give one of them");
}

report::Document withSettings(report::Document document, const std::vector<Setting>& settings) {
  for (const Setting& each : settings) document.facts.push_back({"set " + each.address, each.value, ""});
  return document;
}

CompiledModel readVehicleOf(const ModelFiles& files, double gravity) {
  Vehicle vehicle = readVehicle(files.vehicle).orThrow();
  Settings settings(files.settings);
  settings.apply(vehicle);
  settings.requireRight();
  return compileChecked(std::move(vehicle), gravity);
}

Model readModel(const ModelFiles& files) {
  FileSource disk;
  return vehicle::readModel(files.vehicle, files.scenario, disk, Settings(files.settings));
}

}  // namespace vehicle::cli
