#include "libvehicle/report/run/history_table.h"

#include <algorithm>
#include <utility>

#include "libvehicle/report/document/engineering_units.h"

namespace vehicle::report {

namespace {

/// The numbers of one column behind what leads its row.
void addNumbers(const ColumnSummary& summary, double factor, std::vector<Cell>& row) {
  for (const double value : {summary.lowest, summary.highest, summary.peak()}) row.emplace_back(factor * value);
  row.emplace_back(summary.peakAt());
  for (const double value : {summary.mean, summary.rms}) row.emplace_back(factor * value);
}

Table emptyTable(std::vector<TableColumn> leading) {
  Table table{"columns", std::move(leading), {}};
  table.key_columns = table.columns.size();
  for (const char* name : {"min", "max", "peak"}) table.columns.push_back({name, ""});
  table.columns.push_back({"at", "s", ColumnUnit::kAsGiven});
  for (const char* name : {"mean", "rms"}) table.columns.push_back({name, ""});
  return table;
}

}  // namespace

Table historyTable(const std::vector<Channel>& columns, const std::vector<ColumnSummary>& summaries, Format format) {
  Table table = emptyTable({{"column", ""}, {"unit", ""}});
  for (std::size_t j = 0; j < summaries.size(); ++j) {
    const Channel& column = columns[j + 1];
    ShownUnit unit{column.unit, 1.0};
    if (format == Format::kTable) unit = shownUnit(column.unit, summaries[j].peak());
    std::vector<Cell>& row = table.rows.emplace_back();
    row.emplace_back(column.name);
    row.emplace_back(unit.name);
    addNumbers(summaries[j], unit.factor, row);
  }
  return table;
}

Table speedTable(const std::vector<Channel>& columns, const std::vector<HistorySummary>& runs, Format format) {
  Table table = emptyTable({{"column", ""}, {"unit", ""}, {"speed", "m/s"}});
  for (std::size_t j = 0; j + 1 < columns.size(); ++j) {
    const Channel& column = columns[j + 1];
    double largest = 0.0;
    for (const HistorySummary& each : runs) largest = std::max(largest, each.columns[j].peak());
    ShownUnit unit{column.unit, 1.0};
    if (format == Format::kTable) unit = shownUnit(column.unit, largest);
    for (const HistorySummary& each : runs) {
      std::vector<Cell>& row = table.rows.emplace_back();
      row.emplace_back(column.name);
      row.emplace_back(unit.name);
      row.emplace_back(each.speed);
      addNumbers(each.columns[j], unit.factor, row);
    }
  }
  return table;
}

}  // namespace vehicle::report
