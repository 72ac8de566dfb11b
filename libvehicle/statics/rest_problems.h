#pragma once

#include <vector>

#include <Eigen/Core>

#include "libvehicle/definition/topology.h"

namespace vehicle {

// What is wrong with a vehicle at rest, in words. Private to this room.

/// The forces of a vehicle, or of a part of a train, at rest.
struct RestForces {
  const std::vector<Eigen::VectorXd>& rows;    // (suspensions)(q) elongation = row . q
  const std::vector<double>& suspension_load;  // [N] compression
  const Eigen::VectorXd& given;                // [N, N m] (q) weights and given preloads
  Eigen::VectorXd left;                        // [N, N m] (q) what the springs do not take up
};

/// What acts on a part and nothing takes up, beyond 1e-6 of what acts there and beyond the rounding of weight * length:
/// one problem a part; and one alone, at the suspension, where a given preload leaves opposite forces on its two ends.
[[nodiscard]] ProblemList uncarried(const Topology& topology, double gravity, RestForces forces);

/// Wheels that would have to hang on the rail, and Hertz contacts without a load.
/// @param wheel_load  [N] (wheelsets)
[[nodiscard]] ProblemList wheelsOffTheRail(const Topology& topology, const std::vector<double>& wheel_load);

}  // namespace vehicle
