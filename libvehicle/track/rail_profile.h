#pragma once

#include "libvehicle/definition/scenario.h"

namespace vehicle {

/// Which one-sided limit is meant where a profile has a corner.
enum class Side {
  kLeft,
  kRight
};

/// Height of the rail [m], the mean of both rails, at distance s [m] from the leading wheelset's position at t = 0,
/// straight from the definition: sum of harmonics (times the fade-in), dips, bumps and ramps; with `onset` 0 for s < 0.
/// inputOf() says the same in closed form over time; this one serves plots, teaching and as its witness.
[[nodiscard]] double railHeight(const Track& track, double s);

/// Slope of the rail dz/ds [-]; at a corner the limit from that side.
[[nodiscard]] double railSlope(const Track& track, double s, Side side = Side::kRight);

}  // namespace vehicle
