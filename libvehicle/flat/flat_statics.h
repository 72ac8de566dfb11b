#pragma once

#include <array>

#include "libvehicle/definition/topology.h"
#include "libvehicle/flat/flat_layout.h"
#include "libvehicle/flat/flat_model.h"

namespace vehicle {

/// Static loads of the layout, compression-positive, by the lever rule.
struct FlatLoads {
  std::array<double, 2> secondary{};  // [N]
  std::array<double, 4> primary{};    // [N]
  std::array<double, 4> wheel{};      // [N] wheel-rail force Q0, own weight included; `load` where given
};

/// The carbody's weight goes to the pivots by the lever rule, a bogie's to its axles in proportion to their
/// stiffness, because a bogie that does not pitch presses both equally deep. Where a preload is given, or the lever
/// rule has no answer, this is restOf().
/// @throws InvalidInput if the springs cannot carry the weight, as restOf() says
[[nodiscard]] FlatLoads flatLoads(const Topology& topology, const FlatLayout& layout, double gravity);

[[nodiscard]] FlatParameters flatParameters(const Topology& topology, const FlatLayout& layout, const FlatLoads& loads);

}  // namespace vehicle
