#pragma once

#include <optional>
#include <span>
#include <vector>

#include "libvehicle/linear/mode_following.h"

namespace vehicle {

/// A mode of M and K alone, and what damping makes of it.
struct UndampedMode {
  double frequency = 0.0;  // [Hz]; 0 of a free motion and of one that K does not hold
  FollowedMode damped;
};

/// Modes of the undamped system, each followed while its damping grows from 0 to what it is: how undamped frequencies
/// belong to damped modes, also where two real roots are left of one.
/// @param A  (2N x 2N) [0 1; -K/M -C/M] of the state (q, q')
/// @throws as modesOf()
[[nodiscard]] std::vector<UndampedMode> undampedModesOf(const Eigen::MatrixXd& A, const std::vector<Channel>& states);

/// Undamped frequency of the mode that these roots are of; nothing where they come from several modes or from none that
/// oscillates.
/// @param roots  of modesOf() of the same A
[[nodiscard]] std::optional<double> undampedFrequencyOf(std::span<const Mode> roots,
                                                        std::span<const UndampedMode> undamped);

}  // namespace vehicle
