#pragma once

#include <vector>

#include "libvehicle/definition/topology.h"
#include "libvehicle/diagnostics/warning.h"
#include "libvehicle/result/column_summary.h"
#include "libvehicle/units/channel.h"

namespace vehicle {

/// Where a run left what its model can say:
///     WHEEL_LOAD    a wheel load fell below 0: no contact of these forms can open. Not said without gravity, where loads
///                   are their dynamic part alone
///     LARGE_MOTION  a pitch beyond 0.1 rad or a suspension's deflection beyond 0.5 m: kinematics are linear
/// One warning a column, those that are farthest outside first.
/// @param columns    resultChannels(topology)   @param summaries  of them
[[nodiscard]] Warnings rangeWarnings(const Topology& topology, const std::vector<Channel>& columns,
                                     const std::vector<ColumnSummary>& summaries, double gravity);

inline constexpr double kMostPitch = 0.1;   // [rad]: sin and cos are their series to 0.5 %
inline constexpr double kMostTravel = 0.5;  // [m]

}  // namespace vehicle
