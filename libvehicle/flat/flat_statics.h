#pragma once

#include <array>
#include <optional>

#include "libvehicle/flat/flat_layout.h"
#include "libvehicle/flat/flat_model.h"
#include "libvehicle/model/compiled_model.h"

namespace vehicle {

/// Static loads of the layout, compression-positive, by the lever rule.
struct FlatLoads {
  std::array<double, 2> secondary{};  // [N]
  std::array<double, 4> primary{};    // [N]
  std::array<double, 4> wheel{};      // [N] wheel-rail force Q0, own weight included; `load` where given
};

/// The carbody's weight goes to the pivots by the lever rule, a bogie's to its axles in proportion to their
/// stiffness, because a bogie that does not pitch presses both equally deep: this form's own witness of the rest
/// position. Nothing where a preload is given, or the rule has no answer (a centre of gravity outside the pivots).
[[nodiscard]] std::optional<FlatLoads> leverRule(const Topology& topology, const FlatLayout& layout, double gravity);

/// The loads of the compiled rest position.
[[nodiscard]] FlatLoads loadsAtRest(const Rest& rest, const FlatLayout& layout);

/// By the lever rule, else those at rest.
[[nodiscard]] FlatLoads flatLoads(const CompiledModel& model, const FlatLayout& layout);
/// The same of a vehicle that is not compiled: its rest is found where the lever rule has no answer.
/// @throws InvalidInput if the springs cannot carry the weight, as restOf() says
[[nodiscard]] FlatLoads flatLoads(const Topology& topology, const FlatLayout& layout, double gravity);

[[nodiscard]] FlatParameters flatParameters(const Topology& topology, const FlatLayout& layout, const FlatLoads& loads);

}  // namespace vehicle
