#pragma once

#include "libvehicle/flat/flat_model.h"

namespace vehicle {

/// How fast a design moves, from its numbers alone: cheap enough to be asked of a million designs.
///
/// With k and c the largest row sums of |M^-1/2 K M^-1/2| and |M^-1/2 C M^-1/2| (Gershgorin's bounds of their
/// eigenvalues), an underdamped vehicle, c^2 < 4 k, moves at sqrt(k) at most; else a real root may lie as far out as
/// c/2 + sqrt(c^2/4 + k), which dies out within its own time.
struct DesignPace {
  double fastest = 0.0;  // [rad/s] about max |lambda|, seldom below it
  double step = 0.0;     // [s] an rk4 step that follows it, by the rule of MotionRates::resolvingRk4Step()
};
/// @param duration  [s] of the run
[[nodiscard]] DesignPace paceOf(const FlatParameters& design, double duration);

}  // namespace vehicle
