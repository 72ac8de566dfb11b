#include "apps/cli/history_table.h"

#include "apps/cli/engineering_units.h"

namespace vehicle::cli {

Table historyTable(const std::vector<Channel>& columns, const std::vector<ColumnSummary>& summaries, Format format) {
  Table table{"columns",
              {{"column", ""},
               {"unit", ""},
               {"min", ""},
               {"max", ""},
               {"peak", ""},
               {"at", "s", ColumnUnit::kAsGiven},
               {"mean", ""},
               {"rms", ""}},
              {},
              2};
  for (std::size_t j = 0; j < summaries.size(); ++j) {
    const ColumnSummary& summary = summaries[j];
    const Channel& column = columns[j + 1];
    ShownUnit unit{column.unit, 1.0};
    if (format == Format::kTable) unit = shownUnit(column.unit, summary.peak());
    table.rows.push_back({column.name, unit.name, unit.factor * summary.lowest, unit.factor * summary.highest,
                          unit.factor * summary.peak(), summary.peakAt(), unit.factor * summary.mean,
                          unit.factor * summary.rms});
  }
  return table;
}

}  // namespace vehicle::cli
