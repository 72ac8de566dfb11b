#pragma once

#include <span>
#include <vector>

#include "libvehicle/definition/metric.h"

namespace vehicle {

/// Value below which the share q of the values lies, linear between the order statistics (q = 0.5: the median).
/// @param values  not empty, finite; reordered   @param q  0 .. 1
[[nodiscard]] double percentileOf(std::vector<double>& values, double q);

/// Statistics of equally spaced samples. Keeps workspace: one object a thread.
class ColumnStatistic {
 public:
  /// The statistic that a metric of a column asks for.
  ///
  /// Percentiles are linear between the order statistics. The r.m.s. of a band f1..f2 is that of the lines
  /// f_k = k / T, f1 <= f_k < f2, of the discrete Fourier transform without window, T = n dt, of the n samples before the
  /// last one, which ends the run:
  ///
  ///     sqrt( sum_k g_k |X_k|^2 ) / n,   g_k = 1 for k = 0 and k = n/2, else 2
  ///
  /// so bands that fill 0 Hz to half the sampling rate add up to the mean square, exactly (Parseval).
  /// @param values  not empty   @param step  [s] between them
  /// @throws std::domain_error  if a band lies between two lines or above half the sampling rate: it is too narrow for
  ///                            the length of the run, or too high for its output step
  [[nodiscard]] double operator()(const Metric& metric, std::span<const double> values, double step);

 private:
  [[nodiscard]] double band(std::span<const double> values, double step, double low, double high);

  std::vector<double> sorted_;
  std::vector<double> circle_;  // cos, sin of 2 pi i / n, shape (n x 2)
};

}  // namespace vehicle
