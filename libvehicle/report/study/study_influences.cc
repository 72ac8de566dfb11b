#include "libvehicle/report/study/study_influences.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace vehicle::report {
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

Table formattedTable(const Influence& influence) {
  Table table{"what the factors do to " + influence.output, {{"factor", ""}}, {}, 1};
  for (const char* name : {"first-order index", "total index"}) {
    if (hasIndices(influence)) table.columns.push_back({fmt::format("{} (95 % within)", name), ""});
  }
  return table;
}

constexpr std::size_t kMostPairs = 10;  // of factors, for people

/// To the three decimals that are shown; never -0.
double shown(double index) { return std::round(1e3 * index) / 1e3 + 0.0; }

/// What pairs of factors do together, beyond what each does alone: for people the largest, one table an output.
void addPairs(const Influence& influence, const BoundStudy& bound, bool formatted, Table& all, Document& document) {
  std::vector<PairIndex> pairs = influence.indices.pairs;
  if (pairs.empty()) return;
  if (!formatted) {
    for (const PairIndex& each : pairs) {
      Row& row = all.rows.emplace_back();
      row.emplace_back(influence.output);
      row.emplace_back(bound.factors[each.i].name);
      row.emplace_back(bound.factors[each.j].name);
      for (const double number : {each.second.value, each.second.low, each.second.high}) row.emplace_back(number);
    }
    return;
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const PairIndex& a, const PairIndex& b) {
    return std::abs(a.second.value) > std::abs(b.second.value);
  });
  if (pairs.size() > kMostPairs) {
    document.remarks.push_back(
        fmt::format("{}: {} pairs of factors, the {} largest are shown", influence.output, pairs.size(), kMostPairs));
    pairs.resize(kMostPairs);
  }
  Table table{"what pairs of factors do together to " + influence.output,
              {{"factor", ""}, {"and", ""}, {"second-order index (95 % within)", ""}},
              {},
              2};
  for (const PairIndex& each : pairs) {
    Row& row = table.rows.emplace_back();
    row.emplace_back(bound.factors[each.i].name);
    row.emplace_back(bound.factors[each.j].name);
    row.emplace_back(fmt::format("{:6.3f}  ({:6.3f} .. {:6.3f})", shown(each.second.value), shown(each.second.low),
                                 shown(each.second.high)));
  }
  document.tables.push_back(std::move(table));
}

void addIndices(const SensitivityIndex& index, bool formatted, Row& row) {
  for (const Estimate& estimate : {index.first, index.total}) {
    if (formatted) {
      row.emplace_back(fmt::format("{:.3f}  ({:6.3f} .. {:5.3f})", shown(estimate.value), shown(estimate.low),
                                   shown(estimate.high)));
      continue;
    }
    for (const double number : {estimate.value, estimate.low, estimate.high}) row.emplace_back(number);
  }
}

/// ", with 7 of 1024 blocks" of a Saltelli plan.
std::string blocksOf(const Influence& influence) {
  const SensitivityResult& indices = influence.indices;
  if (indices.left_out == 0) return "";
  return fmt::format(", with {} of {} blocks of the indices", indices.left_out, indices.blocks + indices.left_out);
}

}  // namespace

void addInfluences(const StudySummary& summary, const BoundStudy& bound, Format format, Document& document) {
  const bool formatted = format == Format::kTable;
  // An output that does not vary has no indices, others of the same plan have.
  const bool any_indices = std::any_of(summary.influences.begin(), summary.influences.end(), hasIndices);
  Table all = tableOfAll(any_indices);
  Table all_pairs{"what pairs of factors do", {{"metric", ""}, {"factor", ""}, {"and", ""}}, {}};
  for (const char* end : {"", " low", " high"})
    all_pairs.columns.push_back({fmt::format("second-order index{}", end), ""});
  for (const Influence& each : summary.influences) {
    Table own = formattedTable(each);
    Table& table = formatted ? own : all;
    for (std::size_t factor = 0; factor < bound.factors.size(); ++factor) {
      Row& row = table.rows.emplace_back();
      if (!formatted) row.emplace_back(each.output);
      row.emplace_back(bound.factors[factor].name);
      if (hasIndices(each)) {
        addIndices(each.indices.indices[factor], formatted, row);
      } else if (!formatted) {
        row.resize(all.columns.size());
      }
      row.emplace_back(each.correlations[factor]);
      std::optional<double> coefficient;
      if (each.fit) coefficient = each.fit->coefficients[factor];
      addCell(row, coefficient);
    }
    if (formatted) {
      for (const char* name : {"correlation", "regression"}) own.columns.push_back({name, ""});
      document.tables.push_back(std::move(own));
    }
    addPairs(each, bound, formatted, all_pairs, document);
    if (each.left_out > 0) {
      document.remarks.push_back(fmt::format("{}: {} of {} designs have no value and are left out{}", each.output,
                                             each.left_out, each.designs + each.left_out, blocksOf(each)));
    }
    if (!each.fit) continue;
    document.remarks.push_back(
        fmt::format("{}: straight lines explain {:.1f} % of its variance", each.output, 100.0 * each.fit->explained));
  }
  if (formatted) return;
  for (const char* name : {"correlation", "regression"}) all.columns.push_back({name, ""});
  document.tables.push_back(std::move(all));
  document.tables.push_back(std::move(all_pairs));
}

}  // namespace vehicle::report
