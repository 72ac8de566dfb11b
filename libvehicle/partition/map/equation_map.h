#pragma once

#include <span>
#include <vector>

#include "libvehicle/partition/scheme.h"
#include "libvehicle/system/equation_set.h"

namespace vehicle {

/// In the map `paper`: the thread that also sweeps the rail (6), the paper's thread 2.
inline constexpr int kRailThread = 1;

/// Who computes which equation: (threads) ascending equation numbers, none empty, each equation once.
///
/// paper  thread 1 the rear bogie (5), thread 2 the bounce (2) and the rail (6), thread 3 the pitch (3), thread 4 the
///        front bogie (4): four threads and one vehicle of four equations, whose names carry these numbers.
/// body   the bodies in their order, dealt in contiguous runs of nearly equal cost; a body is the part of an
///        equation's name before its first space.
/// auto   a chain (equations read others near them only): contiguous runs whose heaviest is as light as can be, cut
///        where fewest equations are read across. Any other graph: bisected again and again, each cut bettered by
///        exchanging pairs (Kernighan and Lin, Bell Syst. Tech. J. 49 (1970) 291-307). No randomness: the same shares
///        every time.
/// @param cost  of each equation, > 0, any unit; empty: 1, and 1/2 for each channel it reads
/// @throws std::invalid_argument for a map that does not fit, more threads than equations (or bodies), threads < 1, or
///         costs that do not fit
[[nodiscard]] std::vector<std::vector<int>> shareEquations(const EquationSet& set, EquationMap map, int threads,
                                                           std::span<const double> cost = {});

}  // namespace vehicle
