#include "libvehicle/report/study/study_tables.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/report/study/study_columns.h"
#include "libvehicle/report/study/study_influences.h"

namespace vehicle::report {
namespace {

constexpr std::size_t kMostInFront = 20;       // rows of a front for people
constexpr std::size_t kMostAsColumns = 6;      // designs side by side
constexpr std::size_t kMostMetricColumns = 6;  // metrics of a design in one line
using Row = StudyColumns::Row;

class Tables {
 public:
  Tables(const StudySummary& summary, const StudyInputs& inputs, Format format)
      : summary_(summary), bound_(inputs.bound), columns_(summary, inputs, format), formatted_(columns_.formatted()) {}

  Document document() {
    Document made;
    counts(made);
    compare(made);
    for (std::size_t i = 0; i < summary_.best.size(); ++i) {
      const BoundObjective& objective = bound_.objectives[i];
      std::string name = objective.goal == Goal::kMinimise ? "smallest " : "largest ";
      name += columns_.nameOf(objective);
      if (!bound_.limits.empty()) name += " within the limits";
      made.tables.push_back(designs(std::move(name), summary_.best[i], false));
    }
    front(made);
    addInfluences(summary_, bound_, formatted_ ? Format::kTable : Format::kCsv, made);
    missing(made);
    failures(made);
    return made;
  }

 private:
  void counts(Document& made) const {
    const auto add = [&](const char* name, std::uint64_t count) {
      made.facts.push_back({name, static_cast<long>(count), ""});
    };
    add("designs", summary_.designs);
    add("evaluated", summary_.stored);
    add("failed", summary_.failed);
    if (!bound_.limits.empty()) add("within limits", summary_.within_limits);
    if (summary_.incomplete > 0) add("with values missing", summary_.incomplete);
    if (summary_.warned > 0) add("with warnings", summary_.warned);
  }

  void compare(Document& made) const {
    if (!formatted_) {
      made.tables.push_back(everyNumber());
    } else if (summary_.compared.size() <= kMostAsColumns) {
      made.tables.push_back(sideBySide());
    } else {
      made.tables.push_back(designs("designs", summary_.compared, !bound_.limits.empty()));
    }
    const auto breaks = [](const JudgedDesign& each) { return !each.failed() && !each.keepsLimits(); };
    const bool marked = formatted_ && std::any_of(summary_.compared.begin(), summary_.compared.end(), breaks);
    if (marked) made.remarks.push_back("! breaks a limit");
  }

  /// Parameters and metrics below each other, one column a design.
  Table sideBySide() const {
    Table table{"comparison", {{"quantity", ""}, {"unit", ""}}, {}, 2};
    for (const JudgedDesign& each : summary_.compared) table.columns.push_back({each.name, ""});
    for (std::size_t p = 0; p < columns_.parameters().size(); ++p) {
      Row& row = table.rows.emplace_back();
      row.emplace_back(columns_.parameters()[p].name);
      row.emplace_back(columns_.parameterUnit(p).name);
      for (const JudgedDesign& each : summary_.compared) {
        const double value = each.parameters[p] * columns_.parameterUnit(p).factor;
        if (bound_.limits.empty()) {
          row.emplace_back(value);
        } else {
          row.emplace_back(fmt::format("{:.5g}  ", value));  // as wide as with a mark
        }
      }
    }
    for (std::size_t column = 0; column < columns_.metrics().size(); ++column) {
      Row& row = table.rows.emplace_back();
      row.emplace_back(columns_.metrics()[column].channel.name);
      row.emplace_back(columns_.unitOf(column).name);
      for (const JudgedDesign& each : summary_.compared) row.emplace_back(columns_.textOf(column, each));
    }
    if (!haveWarnings(summary_.compared)) return table;
    Row& row = table.rows.emplace_back();
    row.emplace_back("warnings");
    row.emplace_back("");
    for (const JudgedDesign& each : summary_.compared) row.emplace_back(each.warnings.words());
    return table;
  }

  /// One line a design and number, for other programs.
  Table everyNumber() const {
    Table table{"comparison", columns_.head(), {}};
    for (const char* name : {"quantity", "unit", "value"}) table.columns.push_back({name, ""});
    table.columns.push_back({"change", "%"});
    table.columns.push_back({"keeps limit", ""});
    const auto begin = [&](const JudgedDesign& design, const Channel& channel) -> Row& {
      Row& row = table.rows.emplace_back();
      columns_.addHead(design, row);
      row.emplace_back(channel.name);
      row.emplace_back(channel.unit);
      return row;
    };
    for (const JudgedDesign& each : summary_.compared) {
      for (std::size_t p = 0; p < columns_.parameters().size(); ++p) {
        Row& row = begin(each, columns_.parameters()[p]);
        row.emplace_back(each.parameters[p]);
        row.resize(table.columns.size());
      }
      for (std::size_t column = 0; column < columns_.metrics().size() && !each.failed(); ++column) {
        Row& row = begin(each, columns_.metrics()[column].channel);
        columns_.addNumber(each.metrics[column], row);
        addCell(row, columns_.changeIn(column, each));
        std::optional<bool> keeps = columns_.breaksLimit(column, each.metrics[column]);
        if (keeps) keeps = !*keeps;
        addCell(row, keeps);
      }
    }
    return table;
  }

  /// One line a design: parameters, objectives, and the metrics where they are few.
  Table designs(std::string name, const std::vector<JudgedDesign>& list, bool judged) const {
    Table table{std::move(name), columns_.head(), {}, columns_.head().size()};
    if (formatted_ && judged) table.columns.push_back({"limits", ""});
    for (std::size_t p = 0; p < columns_.parameters().size(); ++p) {
      table.columns.push_back({columns_.parameters()[p].name, columns_.parameterUnit(p).name, ColumnUnit::kAsGiven});
    }
    const bool with_metrics =
        columns_.metrics().size() <= kMostMetricColumns || bound_.objectives.empty() || !formatted_;
    for (const BoundObjective& each : bound_.objectives) {
      if (!with_metrics)
        table.columns.push_back({columns_.nameOf(each), columns_.unitOf(each).name, ColumnUnit::kAsGiven});
      if (columns_.hasWorst(each))
        table.columns.push_back({bound_.metrics[each.metric].metric.name + ", worst at", ""});
    }
    for (std::size_t column = 0; column < columns_.metrics().size() && with_metrics; ++column) {
      table.columns.push_back(
          {columns_.metrics()[column].channel.name, columns_.unitOf(column).name, ColumnUnit::kAsGiven});
    }
    if (!formatted_) table.columns.push_back({"limits", ""});
    const bool warned = !formatted_ || haveWarnings(list);
    if (warned) table.columns.push_back({"warnings", ""});
    for (const JudgedDesign& each : list) {
      Row& row = table.rows.emplace_back();
      columns_.addHead(each, row);
      const std::string verdict = each.failed() ? "failed" : each.keepsLimits() ? "kept" : "broken";
      if (formatted_ && judged) row.emplace_back(verdict);
      for (std::size_t p = 0; p < columns_.parameters().size(); ++p) {
        row.emplace_back(each.parameters[p] * columns_.parameterUnit(p).factor);
      }
      for (std::size_t i = 0; i < bound_.objectives.size(); ++i) addObjective(each, i, !with_metrics, row);
      for (std::size_t column = 0; column < columns_.metrics().size() && with_metrics; ++column) {
        if (formatted_) {
          row.emplace_back(columns_.textOf(column, each));
        } else {
          columns_.addNumber(each.failed() ? StudyColumns::kMissing : each.metrics[column], row);
        }
      }
      if (!formatted_) row.emplace_back(verdict);
      if (warned) row.emplace_back(each.warnings.words());
    }
    return table;
  }

  static bool haveWarnings(const std::vector<JudgedDesign>& list) {
    return std::any_of(list.begin(), list.end(), [](const JudgedDesign& each) { return !each.warnings.empty(); });
  }

  /// The value of an objective, and the case in which the worst of several stands.
  void addObjective(const JudgedDesign& design, std::size_t number, bool with_value, Row& row) const {
    const BoundObjective& objective = bound_.objectives[number];
    if (with_value) {
      columns_.addNumber(
          design.failed() ? StudyColumns::kMissing : design.objectives[number] * columns_.unitOf(objective).factor,
          row);
    }
    if (!columns_.hasWorst(objective)) return;
    std::optional<std::string> worst;
    if (!design.failed() && design.worst[number]) {
      worst = bound_.cases[*columns_.metrics()[*design.worst[number]].study_case].label;
    }
    addCell(row, worst);
  }

  void front(Document& made) const {
    if (bound_.objectives.size() < 2) return;
    std::vector<JudgedDesign> shown = summary_.front;
    if (formatted_ && shown.size() > kMostInFront) {
      shown.clear();
      for (std::size_t i = 0; i < kMostInFront; ++i) {
        shown.push_back(summary_.front[i * (summary_.front.size() - 1) / (kMostInFront - 1)]);
      }
      made.remarks.push_back(fmt::format("the Pareto front has {} designs; {} of them are shown, evenly spaced",
                                         summary_.front.size(), kMostInFront));
    }
    made.tables.push_back(designs("Pareto front", shown, false));
  }

  void missing(Document& made) const {
    Table table{"missing values", {{"designs", ""}, {"metric", ""}, {"why", ""}}, {}};
    for (const MissingValues& each : summary_.missing) {
      Row& row = table.rows.emplace_back();
      row.emplace_back(static_cast<long>(each.designs));
      row.emplace_back(each.metrics);
      row.emplace_back(each.reason);
    }
    made.tables.push_back(std::move(table));
    if (summary_.incomplete == 0) return;
    made.remarks.push_back(fmt::format("- no value: {} of {} designs lack one or more, for the reasons above",
                                       summary_.incomplete, summary_.stored));
  }

  void failures(Document& made) const {
    Table table{"failed designs", columns_.head(), {}};
    table.columns.push_back({"why", ""});
    for (const JudgedDesign& each : summary_.failures) {
      Row& row = table.rows.emplace_back();
      columns_.addHead(each, row);
      row.emplace_back(each.message);
    }
    made.tables.push_back(std::move(table));
    if (summary_.failed > summary_.failures.size()) {
      made.remarks.push_back(
          fmt::format("{} designs failed; the first {} are shown", summary_.failed, summary_.failures.size()));
    }
  }

  const StudySummary& summary_;
  const BoundStudy& bound_;
  StudyColumns columns_;
  bool formatted_;
};

}  // namespace

Document documentOf(const StudySummary& summary, const StudyInputs& inputs, Format format) {
  return Tables(summary, inputs, format).document();
}

}  // namespace vehicle::report
