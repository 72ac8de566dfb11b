#include "apps/cli/study_influences.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace vehicle::cli {
namespace {

using Row = std::vector<Cell>;

bool hasIndices(const Influence& influence) { return !influence.indices.indices.empty(); }

/// With a column for the output, and three for each index: its value and its interval.
Table tableOfAll(bool indices) {
  Table table{"what the factors do", {{"metric", ""}, {"factor", ""}}, {}};
  for (const char* name : {"first-order index", "total index"}) {
    if (!indices) break;
    for (const char* end : {"", " low", " high"}) table.columns.push_back({fmt::format("{}{}", name, end), ""});
  }
  return table;
}

Table tableForEyes(const Influence& influence) {
  Table table{"what the factors do to " + influence.output, {{"factor", ""}}, {}, 1};
  for (const char* name : {"first-order index", "total index"}) {
    if (hasIndices(influence)) table.columns.push_back({fmt::format("{} (95 % within)", name), ""});
  }
  return table;
}

void addIndices(const SensitivityIndex& index, bool for_eyes, Row& row) {
  for (const Estimate& estimate : {index.first, index.total}) {
    if (for_eyes) {
      row.emplace_back(fmt::format("{:.3f}  ({:6.3f} .. {:5.3f})", estimate.value, estimate.low, estimate.high));
      continue;
    }
    for (const double number : {estimate.value, estimate.low, estimate.high}) row.emplace_back(number);
  }
}

}  // namespace

void addInfluences(const StudySummary& summary, const BoundStudy& bound, Format format, Document& document) {
  const bool for_eyes = format == Format::kTable;
  // An output that does not vary has no indices, others of the same plan have.
  const bool any_indices = std::any_of(summary.influences.begin(), summary.influences.end(), hasIndices);
  Table all = tableOfAll(any_indices);
  for (const Influence& each : summary.influences) {
    Table own = tableForEyes(each);
    Table& table = for_eyes ? own : all;
    for (std::size_t factor = 0; factor < bound.factors.size(); ++factor) {
      Row& row = table.rows.emplace_back();
      if (!for_eyes) row.emplace_back(each.output);
      row.emplace_back(bound.factors[factor].name);
      if (hasIndices(each)) {
        addIndices(each.indices.indices[factor], for_eyes, row);
      } else if (!for_eyes) {
        row.resize(all.columns.size());
      }
      row.emplace_back(each.correlations[factor]);
      std::optional<double> coefficient;
      if (each.fit) coefficient = each.fit->coefficients[factor];
      addCell(row, coefficient);
    }
    if (for_eyes) {
      for (const char* name : {"correlation", "regression"}) own.columns.push_back({name, ""});
      document.tables.push_back(std::move(own));
    }
    if (!each.fit) continue;
    document.remarks.push_back(fmt::format("{}: straight lines explain {:.1f} % of its variance", each.output,
                                           100.0 * each.fit->explained));
  }
  if (for_eyes) return;
  for (const char* name : {"correlation", "regression"}) all.columns.push_back({name, ""});
  document.tables.push_back(std::move(all));
}

}  // namespace vehicle::cli
