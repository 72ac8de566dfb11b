#pragma once

#include <vector>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/flat/flat_layout.h"
#include "libvehicle/model/topology_part.h"

namespace vehicle {

/// A flat vehicle in a train.
struct FlatTrainVehicle {
  FlatLayout layout;      // indices into the topology of the train
  Topology own;           // of this vehicle alone
  FlatLayout own_layout;  // indices into that
};

/// Flat vehicles in a row, the leading one (of largest carbody x) first.
struct FlatTrainLayout {
  std::vector<FlatTrainVehicle> vehicles;
  std::vector<int> couplings;  // suspensions; behind each vehicle but the last; -1: there is none
};

/// The layout, or the problems that prevent it; whole only if `problems` is empty.
struct FlatTrainReading {
  FlatTrainLayout layout;
  ProblemList problems;
};

/// Whether it holds several vehicles: units, or bodies on bodies that are joined to each other.
[[nodiscard]] bool isTrain(const Topology& topology);

/// Takes the train apart: couplings are suspensions between bodies that stand on other bodies and on no wheelset; what
/// holds together without them is a vehicle. Reads each as readLayout() does, and the chain of couplings between them.
/// Of vehicles from the same lines of a file one is told.
[[nodiscard]] FlatTrainReading readTrainLayout(const Topology& topology);

}  // namespace vehicle
