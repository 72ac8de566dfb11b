#include "libvehicle/result/column_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vehicle {

ColumnSummaries::ColumnSummaries(std::size_t columns)
    : sum_(columns, 0.0),
      squares_(sum_),
      lowest_(columns, std::numeric_limits<double>::infinity()),
      highest_(columns, -std::numeric_limits<double>::infinity()),
      lowest_at_(sum_),
      highest_at_(sum_),
      before_(sum_),
      previous_(sum_) {}

void ColumnSummaries::look(std::size_t column, double t, double value) {
  if (value < lowest_[column]) {
    lowest_[column] = value;
    lowest_at_[column] = t;
  }
  if (value > highest_[column]) {
    highest_[column] = value;
    highest_at_[column] = t;
  }
}

void ColumnSummaries::begin(double t, double weight, std::span<const double> values) {
  known_ = 0;
  add(t, weight, values);
}

void ColumnSummaries::add(double t, double weight, std::span<const double> values) {
  time_ += weight;
  const double h1 = t_previous_ - t_before_;
  const double h2 = t - t_previous_;
  const std::size_t columns = sum_.size();
  for (std::size_t i = 0; i < columns; ++i) sum_[i] += weight * values[i];
  for (std::size_t i = 0; i < columns; ++i) squares_[i] += weight * values[i] * values[i];
  for (std::size_t i = 0; i < columns; ++i) look(i, t, values[i]);
  for (std::size_t i = 0; known_ == 2 && i < columns; ++i) {
    const double rise = previous_[i] - before_[i];
    const double fall = values[i] - previous_[i];
    if (!(rise * fall < 0.0)) continue;
    const double bend = (fall / h2 - rise / h1) / (h1 + h2);
    const double slope = (rise / h1 * h2 + fall / h2 * h1) / (h1 + h2);  // at the middle sample
    look(i, t_previous_ - 0.5 * slope / bend, previous_[i] - 0.25 * slope * slope / bend);
  }
  before_.swap(previous_);
  std::copy(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(columns), previous_.begin());
  t_before_ = t_previous_;
  t_previous_ = t;
  if (known_ < 2) ++known_;
}

std::vector<ColumnSummary> ColumnSummaries::summaries() const {
  std::vector<ColumnSummary> made(sum_.size());
  if (!(time_ > 0.0)) return made;
  for (std::size_t i = 0; i < made.size(); ++i) {
    // Weights of an end may be negative, which rounding could show in a column of zeros.
    made[i] = {sum_[i] / time_, std::sqrt(std::fmax(0.0, squares_[i] / time_)), lowest_[i], highest_[i], lowest_at_[i],
               highest_at_[i]};
  }
  return made;
}

}  // namespace vehicle
