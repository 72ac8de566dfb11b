#pragma once

#include <vector>

#include "libvehicle/linear/branches.h"
#include "libvehicle/linear/mode_following.h"

namespace vehicle {

// Where following begins. Private to this room.

/// Modes of a matrix, real roots two by two: those into which growing damping has parted one undamped mode; what is
/// left over by its names.
[[nodiscard]] std::vector<WholeMode> wholeModesOf(const Eigen::MatrixXd& A, const std::vector<Channel>& states);

/// Their branches.
/// @param groups  of A in these units
[[nodiscard]] std::vector<Branch> firstBranches(const std::vector<WholeMode>& modes,
                                                const std::vector<RootGroup>& groups, const Eigen::VectorXd& units);

}  // namespace vehicle
