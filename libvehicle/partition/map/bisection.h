#pragma once

#include <vector>

#include "libvehicle/partition/map/equation_graph.h"

namespace vehicle {

/// The equations of any graph in `parts` shares of nearly equal cost with few neighbours across: cut in two in their
/// order by cost, the cut bettered by moving and exchanging equations (Kernighan and Lin) as long as that lowers the
/// heaviest side or, at equal sides, the number of neighbours across; then each side the same way. Deterministic.
/// Meant for the few dozen equations of a vehicle: O(n^3).
/// @param cost  (n) > 0
/// @return  (parts) ascending equations, none empty
[[nodiscard]] std::vector<std::vector<int>> bisected(const EquationGraph& graph, const std::vector<double>& cost,
                                                     int parts);

}  // namespace vehicle
