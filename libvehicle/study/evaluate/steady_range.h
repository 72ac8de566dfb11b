#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "libvehicle/diagnostics/warning_set.h"
#include "libvehicle/model/layout.h"
#include "libvehicle/study/evaluate/steady_statistic.h"

namespace vehicle {

// Where a steady state leaves what the model can say, as run_warnings.h has it for runs.

enum class RangeKind {
  kLoad,    // of a wheel [N]: not below 0
  kPitch,   // of a body [rad]
  kTravel,  // of a suspension [m]
};

/// A column with a range, by its place among columns.
struct RangeColumn {
  std::size_t column = 0;
  RangeKind kind = RangeKind::kLoad;
};

/// The columns of a form that have a range.
[[nodiscard]] std::vector<RangeColumn> rangeColumns(const OutputLayout& layout);

/// Whether mean + sum_f Re[X_f e^(i w_f t)] leaves its range. The sum of |X_f| settles it for most; else the motion is
/// sampled over its common period, and where there is none it comes as near to that sum as one likes.
/// @param amplitudes  (F)   @param statistic  of their frequencies
[[nodiscard]] bool leavesRange(RangeKind kind, double mean, std::span<const std::complex<double>> amplitudes,
                               SteadyStatistic& statistic);

/// WHEEL_LOAD or LARGE_MOTION.
[[nodiscard]] WarningCode rangeCode(RangeKind kind);

}  // namespace vehicle
