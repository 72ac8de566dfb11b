#include "libvehicle/project/train_design.h"

#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/definition/parameter.h"

namespace vehicle {
namespace {

using Values = std::map<std::string, double, std::less<>>;

Values valuesOf(const Vehicle& vehicle) {
  Values values;
  for (const VehicleParameter& each : parametersOf(vehicle)) {
    if (const std::optional<double> value = each.valueIn(vehicle)) values.emplace(each.address, *value);
  }
  return values;
}

/// The vehicle of a unit with the design's numbers.
Vehicle vehicleOf(const Vehicle& file, const std::string& unit, const Values& base, const Values& design) {
  Vehicle made = file;
  for (const VehicleParameter& each : parametersOf(file)) {
    const std::string address = unit + '.' + each.address;
    const auto is = design.find(address);
    if (is == design.end()) continue;
    const auto was = base.find(address);
    if (was != base.end() && was->second == is->second) continue;
    // A place in the train is that in the file, moved with the unit.
    const bool is_place = each.address.ends_with(".x") && was != base.end();
    each.setIn(made, is_place ? *each.valueIn(file) + (is->second - was->second) : is->second);
  }
  return made;
}

void setCouplings(const Values& design, Train& train) {
  for (std::size_t i = 0; i < train.couplings.size(); ++i) {
    const std::string element = train.couplings.size() == 1 && design.contains("coupling.stiffness_z")
                                    ? "coupling"
                                    : fmt::format("coupling_element_{}", i + 1);
    if (const auto found = design.find(element + ".stiffness_z"); found != design.end()) {
      train.couplings[i].stiffness_z = found->second;
    }
    if (const auto found = design.find(element + ".damping_z"); found != design.end()) {
      train.couplings[i].damping_z = found->second;
    }
  }
}

/// What the file says has to be the design again, but for the rounding of places that are moved forth and back.
void requireSame(const Train& train, const Values& design) {
  const Values again = valuesOf(assembled(train));
  for (const auto& [address, value] : design) {
    const auto found = again.find(address);
    if (found != again.end() && std::abs(found->second - value) <= 1e-12 * std::max(1.0, std::abs(value))) continue;
    throw std::invalid_argument(fmt::format("{} of a design cannot be said in the file of a train", address));
  }
}

}  // namespace

Train trainOf(const Train& train, const Vehicle& base, const Vehicle& design, const std::string& name) {
  const Values was = valuesOf(base);
  const Values is = valuesOf(design);
  Train made = train;
  made.vehicles.clear();
  std::size_t unit = 0;
  for (const TrainVehicle& group : train.vehicles) {
    for (int k = 0; k < group.count; ++k, ++unit) {
      const std::string& called = base.units[unit].name;
      Vehicle vehicle = vehicleOf(group.vehicle, called, was, is);
      if (k > 0 && made.vehicles.back().vehicle == vehicle) {
        ++made.vehicles.back().count;
        continue;
      }
      TrainVehicle next = group;
      if (next.name.empty()) next.name = group.vehicle.name;
      next.count = 1;
      next.file = fmt::format("{}-{}.xml", name, called);
      next.vehicle = std::move(vehicle);
      made.vehicles.push_back(std::move(next));
    }
  }
  setCouplings(is, made);
  requireSame(made, is);
  return made;
}

}  // namespace vehicle
