#pragma once

#include <vector>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/model/topology.h"
#include "libvehicle/statics/rest_balance.h"

namespace vehicle {

// What is wrong with a vehicle at rest, in words. Private to this room.

/// What acts on a part and nothing takes up, beyond 1e-6 of what acts there and beyond the rounding of weight * length:
/// one problem a part; and one alone, at the suspension, where a given preload leaves opposite forces on its two ends.
[[nodiscard]] ProblemList uncarried(const Topology& topology, double gravity, const RestBalance& balance,
                                    const RestSolution& solved);

/// Wheels that would have to hang on the rail, and Hertz contacts without a load.
/// @param wheel_load  [N] (wheelsets)
[[nodiscard]] ProblemList wheelsOffTheRail(const Topology& topology, const std::vector<double>& wheel_load);

}  // namespace vehicle
