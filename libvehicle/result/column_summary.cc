#include "libvehicle/result/column_summary.h"

#include <cmath>
#include <limits>

namespace vehicle {

ColumnSummaries::ColumnSummaries(std::size_t columns) : columns_(columns) {
  for (Column& each : columns_) {
    each.lowest = std::numeric_limits<double>::infinity();
    each.highest = -each.lowest;
  }
}

void ColumnSummaries::look(Column& column, double t, double value) const {
  if (value < column.lowest) {
    column.lowest = value;
    column.lowest_at = t;
  }
  if (value > column.highest) {
    column.highest = value;
    column.highest_at = t;
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
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    Column& column = columns_[i];
    const double value = values[i];
    column.sum += weight * value;
    column.squares += weight * value * value;
    look(column, t, value);
    if (known_ == 2) {
      const double rise = column.previous - column.before;
      const double fall = value - column.previous;
      if (rise * fall < 0.0) {
        const double bend = (fall / h2 - rise / h1) / (h1 + h2);
        const double slope = (rise / h1 * h2 + fall / h2 * h1) / (h1 + h2);  // at the middle sample
        look(column, t_previous_ - 0.5 * slope / bend, column.previous - 0.25 * slope * slope / bend);
      }
    }
    column.before = column.previous;
    column.previous = value;
  }
  t_before_ = t_previous_;
  t_previous_ = t;
  if (known_ < 2) ++known_;
}

std::vector<ColumnSummary> ColumnSummaries::summaries() const {
  std::vector<ColumnSummary> made(columns_.size());
  if (!(time_ > 0.0)) return made;
  for (std::size_t i = 0; i < made.size(); ++i) {
    const Column& column = columns_[i];
    // Weights of an end may be negative, which rounding could show in a column of zeros.
    made[i] = {column.sum / time_, std::sqrt(std::fmax(0.0, column.squares / time_)),
               column.lowest,      column.highest,
               column.lowest_at,   column.highest_at};
  }
  return made;
}

}  // namespace vehicle
