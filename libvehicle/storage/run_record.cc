#include "libvehicle/storage/run_record.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace vehicle {

void requireStorable(const TimeHistory& history) {
  if (history.columns().empty()) throw std::invalid_argument("history: has no columns, must have at least \"time\"");
  for (std::size_t i = 0; i < history.samples(); ++i) {
    const std::span<const double> row = history.row(i);
    for (std::size_t j = 0; j < row.size(); ++j) {
      if (std::isfinite(row[j])) continue;
      throw std::invalid_argument(fmt::format("history: column \"{}\" is {} at time {} s, must be finite",
                                              history.columns()[j].name, row[j], row[0]));
    }
  }
}

}  // namespace vehicle
