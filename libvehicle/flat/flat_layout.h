#pragma once

#include <array>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/model/topology.h"

namespace vehicle {

/// Which part of a vehicle plays which part in the equations: indices into the topology. Front and wheel 1 are
/// those of larger x; at equal x the file's order decides.
struct FlatLayout {
  int carbody = -1;
  std::array<int, 2> bogie{-1, -1};            // front, rear
  std::array<int, 2> secondary{-1, -1};        // suspensions: carbody on front, on rear bogie
  std::array<int, 4> primary{-1, -1, -1, -1};  // suspensions: bogies on wheels 1 to 4
  std::array<int, 4> wheelset{-1, -1, -1, -1};
  bool operator==(const FlatLayout&) const = default;
};

/// The layout, or the problems that prevent it; whole only if `problems` is empty.
struct FlatReading {
  FlatLayout layout;
  ProblemList problems;
};

[[nodiscard]] FlatReading readLayout(const Topology& topology);

/// What hinders the printed variants of a vehicle that fits the consistent one: they know one bogie, one primary,
/// one secondary, one lever arm, and no static loads at heights.
[[nodiscard]] ProblemList asymmetries(const Topology& topology, const FlatLayout& layout);

}  // namespace vehicle
