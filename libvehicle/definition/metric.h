#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace vehicle {

enum class MetricKind {
  kColumn,  // a statistic of a result column
  kMode,    // a frequency or the damping of a natural mode
  kStatic,  // what stands at rest
};

enum class Statistic {
  kRms,                 // root of the mean of x^2
  kMean,                // mean of x
  kPeak,                // max |x|
  kMin,                 // min x
  kMax,                 // max x
  kPercentile,          // of x
  kAbsolutePercentile,  // of |x|
  kBand,                // r.m.s. of what lies between two frequencies
};

/// One number by which designs are compared.
///
///     carbody.az.rms | .mean | .peak | .min | .max         of the column carbody.az
///     carbody.az.p99.85, carbody.az.abs_p95                percentile of x, of |x|
///     carbody.az.band(4..8 Hz)                             r.m.s. of the part between 4 and 8 Hz
///     mode.carbody bounce.frequency                        by the mode's name: |lambda| / 2 pi [Hz]
///     mode.carbody bounce.damped_frequency                 |Im lambda| / 2 pi [Hz]
///     mode.carbody bounce.undamped_frequency               of masses and stiffnesses alone [Hz]
///     mode.carbody bounce.damping                          damping ratio, -Re lambda / |lambda| [-]
///     static.secondary_front.deflection | .load            of a suspension at rest, compression-positive [m], [N]
///     static.wheelset_1.load                               wheel-rail force Q0 [N]
/// What follows the last word tells the kind, so that no name of a part is forbidden.
struct Metric {
  std::string name;  // as written, without the spaces around it
  MetricKind kind = MetricKind::kColumn;
  std::string subject;                    // "carbody.az", "carbody bounce", "secondary_front"
  Statistic statistic = Statistic::kRms;  // of a kColumn
  double percent = 0.0;                   // of the percentiles, 0 < percent < 100
  double low = 0.0;                       // [Hz] of a kBand, >= 0
  double high = 0.0;                      // [Hz] > low
  std::string quantity;                   // of the other kinds: "frequency", "damping", "deflection", ...
  bool operator==(const Metric&) const = default;
};

/// A metric, read; or why not.
struct ParsedMetric {
  std::optional<Metric> metric;
  std::string message;  // when !metric: e.g. `ends in no statistic`
  std::string remedy;
};

[[nodiscard]] ParsedMetric parseMetric(std::string_view text);

/// SI unit of a metric: the column's for statistics, "Hz", "m", "N" or "" for the others.
/// @param column_unit  of the column that it is taken from; not asked for the other kinds
[[nodiscard]] std::string unitOf(const Metric& metric, std::string_view column_unit);

}  // namespace vehicle
