#include "libvehicle/study/evaluate/steady_range.h"

#include <cmath>
#include <stdexcept>

#include "libvehicle/simulate/run_warnings.h"

namespace vehicle {

namespace {

double statisticOf(Statistic statistic, double mean, std::span<const std::complex<double>> amplitudes,
                   SteadyStatistic& of, double without_period) {
  Metric metric;
  metric.statistic = statistic;
  try {
    return of(metric, mean, amplitudes);
  } catch (const std::domain_error&) {
    return without_period;
  }
}

}  // namespace

std::vector<RangeColumn> rangeColumns(const OutputLayout& layout) {
  std::vector<RangeColumn> found;
  for (std::size_t column = 0; column < layout.keys().size(); ++column) {
    const Quantity quantity = layout.keys()[column].quantity;
    if (quantity == Quantity::kLoad) found.push_back({column, RangeKind::kLoad});
    if (quantity == Quantity::kPitch) found.push_back({column, RangeKind::kPitch});
    if (quantity == Quantity::kDeflection) found.push_back({column, RangeKind::kTravel});
  }
  return found;
}

bool leavesRange(RangeKind kind, double mean, std::span<const std::complex<double>> amplitudes,
                 SteadyStatistic& statistic) {
  double sum = 0.0;
  for (const std::complex<double>& each : amplitudes) sum += std::abs(each);
  if (kind == RangeKind::kLoad) {
    // What rounding leaves of a load that just reaches 0 is no pull.
    const double least = -1e-9 * (std::abs(mean) + sum);
    return mean - sum < least && statisticOf(Statistic::kMin, mean, amplitudes, statistic, mean - sum) < least;
  }
  const double most = kind == RangeKind::kPitch ? kMostPitch : kMostTravel;
  const double bound = std::abs(mean) + sum;
  return bound > most && statisticOf(Statistic::kPeak, mean, amplitudes, statistic, bound) > most;
}

WarningCode rangeCode(RangeKind kind) {
  return kind == RangeKind::kLoad ? WarningCode::kWheelLoad : WarningCode::kLargeMotion;
}

}  // namespace vehicle
