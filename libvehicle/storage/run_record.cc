#include "libvehicle/storage/run_record.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace vehicle {

void requireStorable(const std::vector<Channel>& columns, std::span<const double> row) {
  double zero = 0.0;
  for (const double value : row) zero += 0.0 * value;
  if (zero == 0.0) return;
  for (std::size_t j = 0; j < row.size(); ++j) {
    if (std::isfinite(row[j])) continue;
    throw std::invalid_argument(
        fmt::format("history: column \"{}\" is {} at time {} s, must be finite", columns[j].name, row[j], row[0]));
  }
}

void requireStorable(const TimeHistory& history) {
  if (history.columns().empty()) throw std::invalid_argument("history: has no columns, must have at least \"time\"");
  for (std::size_t i = 0; i < history.samples(); ++i) requireStorable(history.columns(), history.row(i));
}

}  // namespace vehicle
