#include "apps/cli/history_table.h"

#include <algorithm>
#include <cmath>

namespace vehicle::cli {

Table historyTable(const TimeHistory& history) {
  Table table{
      "columns", {{"column", ""}, {"unit", ""}, {"min", ""}, {"max", ""}, {"peak", ""}, {"at", "s"}, {"rms", ""}}, {}};
  for (std::size_t j = 1; j < history.columns().size(); ++j) {
    double low = history.at(0, j), high = low, peak = std::abs(low), at = history.at(0, 0), squares = 0.0;
    for (std::size_t i = 0; i < history.samples(); ++i) {
      const double value = history.at(i, j);
      low = std::min(low, value);
      high = std::max(high, value);
      squares += value * value;
      if (std::abs(value) > peak) {
        peak = std::abs(value);
        at = history.at(i, 0);
      }
    }
    const double rms = std::sqrt(squares / static_cast<double>(history.samples()));
    table.rows.push_back({history.columns()[j].name, history.columns()[j].unit, low, high, peak, at, rms});
  }
  return table;
}

}  // namespace vehicle::cli
