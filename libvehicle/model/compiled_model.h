#pragma once

#include <vector>

#include "libvehicle/definition/vehicle.h"
#include "libvehicle/law/suspension_law.h"
#include "libvehicle/model/layout.h"
#include "libvehicle/model/rest.h"
#include "libvehicle/model/topology.h"

namespace vehicle {

/// A vehicle compiled once, from which every form, study and command starts: names looked up, rest position found,
/// places of states, columns and input channels given out. Const for whoever gets it; it holds no equations.
struct CompiledModel {
  Vehicle vehicle;       // as the user said it: what messages refer to
  double gravity = 0.0;  // [m/s^2] that it rests under
  Topology topology;
  Rest rest;                           // static loads
  std::vector<SuspensionLawPtr> laws;  // (suspensions)
  StateLayout states;
  std::vector<OutputKey> state_keys;    // what each state is
  std::vector<Channel> state_channels;  // its name and unit
  OutputLayout outputs;
  InputLayout inputs;
};

/// Checks and compiles.
/// @param gravity  [m/s^2] >= 0
/// @throws InvalidInput if the vehicle contradicts itself (check()), or its springs cannot carry the weight
/// @throws std::invalid_argument unless gravity is finite and >= 0
[[nodiscard]] CompiledModel compile(Vehicle vehicle, double gravity);

/// The same of a vehicle that check() has judged already, as readers of files do.
/// @throws InvalidInput if its springs cannot carry the weight
[[nodiscard]] CompiledModel compileChecked(Vehicle vehicle, double gravity);

}  // namespace vehicle
