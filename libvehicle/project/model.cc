#include "libvehicle/project/model.h"

#include <algorithm>
#include <utility>

#include "libvehicle/xml/reader.h"

namespace vehicle {

Model readModel(const std::string& vehicle_file, const std::string& scenario_file, FileSource& files,
                Settings settings) {
  Outcome<Vehicle> vehicle = readVehicle(vehicle_file, files);
  Outcome<Scenario> scenario = readScenario(scenario_file, files);
  ProblemList problems = vehicle.problems;
  problems.append(scenario.problems);
  if (problems.empty()) {
    settings.apply(*vehicle.value);
    settings.apply(*scenario.value);
    settings.requireRight();
    problems.append(check(*scenario.value, *vehicle.value));
  }
  if (!problems.empty()) throw InvalidInput(std::move(problems));

  Model model{compileChecked(std::move(*vehicle.value), scenario.value->gravity), std::move(*scenario.value), {},
              settings.all()};
  std::vector<std::string> paths = {vehicle_file, scenario_file};
  // The parts of a train know the files of its vehicles.
  for (const Body& body : model.vehicle.vehicle.bodies) paths.push_back(body.origin.file);
  for (const std::string& path : paths) {
    const bool is_kept =
        std::any_of(model.inputs.begin(), model.inputs.end(), [&](const InputFile& each) { return each.name == path; });
    if (!is_kept) model.inputs.push_back({path, files.text(path).value.value()});
  }
  return model;
}

}  // namespace vehicle
