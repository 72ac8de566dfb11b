#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace vehicle {

/// Means and extremes of a column over the part of a run that is measured.
struct ColumnSummary {
  double mean = 0.0;  // (1/T) int y dt
  double rms = 0.0;   // sqrt((1/T) int y^2 dt)
  double lowest = 0.0;
  double highest = 0.0;
  double lowest_at = 0.0;   // [s]
  double highest_at = 0.0;  // [s]

  [[nodiscard]] double peak() const { return -lowest > highest ? -lowest : highest; }  // max |y|
  [[nodiscard]] double peakAt() const { return -lowest > highest ? lowest_at : highest_at; }
};

/// Gathers the summaries of all columns while a run goes by, in constant memory.
///
/// Integrals are sums of weight times value, so they are as good as the weights. An extreme is the largest value seen, or
/// the vertex of the parabola through three neighbouring samples of one smooth part whose middle one is the largest: with
/// N samples a period of a sine its height is right to (2 pi / N)^4 / 40.
class ColumnSummaries {
 public:
  explicit ColumnSummaries(std::size_t columns);

  /// First sample of a smooth part: nothing is known of the motion before it.
  void begin(double t, double weight, std::span<const double> values);
  /// The next sample of the same part.
  /// @param weight  [s] of the integral   @param values  (columns)
  void add(double t, double weight, std::span<const double> values);

  /// @return (columns); all zero before the first sample
  [[nodiscard]] std::vector<ColumnSummary> summaries() const;

 private:
  void look(std::size_t column, double t, double value);

  // Of all columns, one array a quantity: the sums run over neighbours in memory.
  std::vector<double> sum_, squares_;
  std::vector<double> lowest_, highest_, lowest_at_, highest_at_;
  std::vector<double> before_, previous_;  // two samples ago, a sample ago
  double time_ = 0.0;  // sum of the weights
  int known_ = 0;      // samples of this part, at most 2
  double t_before_ = 0.0;
  double t_previous_ = 0.0;
};

}  // namespace vehicle
