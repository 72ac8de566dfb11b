#pragma once

#include <optional>
#include <string>
#include <utility>

#include "libvehicle/definition/train.h"
#include "tests/support/vehicles.h"

// Trains built by hand from the vehicles of vehicles.h.
namespace vehicle::test {

inline TrainVehicle unitsOf(Vehicle vehicle, std::string name, int count, double spacing,
                            std::optional<double> end_x = std::nullopt) {
  TrainVehicle made;
  made.file = vehicle.name + ".xml";
  made.name = std::move(name);
  made.count = count;
  made.spacing = spacing;
  made.end_x = end_x;
  made.vehicle = std::move(vehicle);
  return made;
}

inline Coupling coupling(double stiffness, double damping, std::optional<double> end_x = std::nullopt) {
  Coupling made;
  made.stiffness_z = stiffness;
  made.damping_z = damping;
  made.end_x = end_x;
  return made;
}

/// Equal vehicles whose ends meet: 50 kN/m and 20 kN s/m from end to end.
inline Train equalTrain(const Vehicle& vehicle, int count, double spacing) {
  Train made;
  made.name = "equal";
  made.vehicles = {unitsOf(vehicle, "coach", count, spacing)};
  made.couplings = {coupling(50e3, 20e3, 0.5 * spacing)};
  return made;
}

/// Three unlike vehicles with two unlike couplings, whose ends do not meet: the lopsided vehicle, the paper's, the
/// lopsided one again. 12 coordinates, 12 wheelsets, the files in their own orders.
inline Train mixedTrain() {
  Train made;
  made.name = "mixed";
  made.vehicles = {unitsOf(asymmetricVehicle(), "power", 1, 19.0, 7.5), unitsOf(paperVehicle(), "", 1, 16.0, 7.2),
                   unitsOf(asymmetricVehicle(), "power", 1, 21.0)};
  made.couplings = {coupling(180e3, 12e3), coupling(90e3, 30e3, 8.1)};
  return made;
}

}  // namespace vehicle::test
