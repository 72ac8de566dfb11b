#pragma once

#include <vector>

#include "libvehicle/diagnostics/warning.h"
#include "libvehicle/model/layout.h"
#include "libvehicle/result/column_summary.h"

namespace vehicle {

/// Where a run left what its model can say:
///     WHEEL_LOAD    a wheel load fell below 0: no contact of these forms can open. Not said without gravity, where loads
///                   are their dynamic part alone
///     LARGE_MOTION  a pitch beyond 0.1 rad or a suspension's deflection beyond 0.5 m: kinematics are linear
/// One warning a column, those that are farthest outside first.
/// @param summaries  of the columns of the layout
[[nodiscard]] Warnings rangeWarnings(const OutputLayout& layout, const std::vector<ColumnSummary>& summaries,
                                     double gravity);

inline constexpr double kMostPitch = 0.1;   // [rad]: sin and cos are their series to 0.5 %
inline constexpr double kMostTravel = 0.5;  // [m]

}  // namespace vehicle
