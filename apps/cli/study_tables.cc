#include "apps/cli/study_tables.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "apps/cli/study_influences.h"
#include "apps/cli/study_units.h"

namespace vehicle::cli {
namespace {

constexpr std::size_t kMostInFront = 20;       // rows of a front for eyes
constexpr std::size_t kMostAsColumns = 6;      // designs side by side
constexpr std::size_t kMostMetricColumns = 6;  // metrics of a design in one line

double changeOf(double value, double base) { return 100.0 * (value / base - 1.0); }

using Row = std::vector<Cell>;

class Tables {
 public:
  Tables(const StudySummary& summary, const StudyInputs& inputs, Format format)
      : summary_(summary),
        bound_(inputs.bound),
        columns_(metricColumns(inputs.bound)),
        parameters_(parameterColumns(inputs.bound)),
        for_eyes_(format == Format::kTable),
        broken_by_(columns_.size()) {
    for (std::size_t limit = 0; limit < bound_.limits.size(); ++limit) {
      for (std::size_t column = 0; column < columns_.size(); ++column) {
        if (columns_[column].metric == bound_.limits[limit].metric) broken_by_[column].push_back(limit);
      }
    }
    if (!summary.compared.empty() && summary.compared.front().id == 0 && !summary.compared.front().failed()) {
      base_ = &summary.compared.front();
    }
    chooseUnits();
  }

  Document document() {
    Document made;
    compare(made);
    for (std::size_t i = 0; i < summary_.best.size(); ++i) {
      const BoundObjective& objective = bound_.objectives[i];
      std::string name = objective.goal == Goal::kMinimise ? "smallest " : "largest ";
      name += nameOf(objective);
      if (!bound_.limits.empty()) name += " within the limits";
      made.tables.push_back(designs(std::move(name), summary_.best[i], false));
    }
    front(made);
    addInfluences(summary_, bound_, for_eyes_ ? Format::kTable : Format::kCsv, made);
    failures(made);
    return made;
  }

 private:
  std::string nameOf(const BoundObjective& objective) const {
    const std::string& name = bound_.metrics[objective.metric].metric.name;
    const auto cases = std::count_if(columns_.begin(), columns_.end(),
                                     [&](const MetricColumn& each) { return each.metric == objective.metric; });
    if (cases < 2) return name;
    return fmt::format("{}, {} of {}", name, objective.over == Over::kMean ? "mean" : "worst", cases);
  }

  /// One unit a parameter and one a metric, the same in every table; SI for other programs.
  void chooseUnits() {
    std::vector<double> largest(parameters_.size() + bound_.metrics.size(), 0.0);
    const auto see = [&](const JudgedDesign& each) {
      for (std::size_t i = 0; i < parameters_.size(); ++i) {
        largest[i] = std::max(largest[i], std::abs(each.parameters[i]));
      }
      for (std::size_t i = 0; i < each.metrics.size(); ++i) {
        double& own = largest[parameters_.size() + columns_[i].metric];
        own = std::max(own, std::abs(each.metrics[i]));
      }
    };
    if (for_eyes_) std::for_each(summary_.compared.begin(), summary_.compared.end(), see);
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
      parameter_units_.push_back(shownUnit(parameters_[i].unit, largest[i]));
    }
    for (std::size_t i = 0; i < bound_.metrics.size(); ++i) {
      metric_units_.push_back(shownUnit(bound_.metrics[i].unit, largest[parameters_.size() + i]));
    }
  }

  const ShownUnit& unitOf(std::size_t column) const { return metric_units_[columns_[column].metric]; }

  bool breaksLimit(std::size_t column, double value) const {
    return std::any_of(broken_by_[column].begin(), broken_by_[column].end(), [&](std::size_t number) {
      const BoundLimit& limit = bound_.limits[number];
      return (limit.below && value > *limit.below) || (limit.above && value < *limit.above);
    });
  }

  /// A metric with its change, in columns of their own width so that values stand below each other.
  std::string eyesOn(std::size_t column, const JudgedDesign& design) const {
    if (design.failed()) return "failed";
    const double value = design.metrics[column];
    std::string text = fmt::format("{:.5g}", value * unitOf(column).factor + 0.0);
    if (base_ != nullptr && design.id != 0 && base_->metrics[column] != 0.0) {
      const double change = std::round(10.0 * changeOf(value, base_->metrics[column])) / 10.0;
      text += fmt::format(" ({:+.1f} %)", change + 0.0);  // never -0.0
    }
    if (!bound_.limits.empty()) text += breaksLimit(column, value) ? " !" : "  ";
    return text;
  }

  void compare(Document& made) const {
    if (!for_eyes_) {
      made.tables.push_back(everyNumber());
    } else if (summary_.compared.size() <= kMostAsColumns) {
      made.tables.push_back(sideBySide());
    } else {
      made.tables.push_back(designs("designs", summary_.compared, !bound_.limits.empty()));
    }
    const auto breaks = [](const JudgedDesign& each) { return !each.failed() && !each.keepsLimits(); };
    const bool marked = for_eyes_ && std::any_of(summary_.compared.begin(), summary_.compared.end(), breaks);
    if (marked) made.remarks.push_back("! breaks a limit");
  }

  /// Parameters and metrics below each other, one column a design.
  Table sideBySide() const {
    Table table{"comparison", {{"quantity", ""}, {"unit", ""}}, {}, 2};
    for (const JudgedDesign& each : summary_.compared) table.columns.push_back({each.name, ""});
    for (std::size_t p = 0; p < parameters_.size(); ++p) {
      Row& row = table.rows.emplace_back();
      row.emplace_back(parameters_[p].name);
      row.emplace_back(parameter_units_[p].name);
      for (const JudgedDesign& each : summary_.compared) {
        const double value = each.parameters[p] * parameter_units_[p].factor;
        if (bound_.limits.empty()) {
          row.emplace_back(value);
        } else {
          row.emplace_back(fmt::format("{:.5g}  ", value));  // as wide as with a mark
        }
      }
    }
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      Row& row = table.rows.emplace_back();
      row.emplace_back(columns_[column].channel.name);
      row.emplace_back(unitOf(column).name);
      for (const JudgedDesign& each : summary_.compared) row.emplace_back(eyesOn(column, each));
    }
    return table;
  }

  /// One line a design and number, for other programs.
  Table everyNumber() const {
    Table table{"comparison", {{"design", ""}, {"name", ""}, {"quantity", ""}, {"unit", ""}, {"value", ""}}, {}};
    table.columns.push_back({"change", "%"});
    table.columns.push_back({"keeps limit", ""});
    for (const JudgedDesign& each : summary_.compared) {
      const auto tell = [&](const Channel& channel, double value, std::optional<double> change,
                            std::optional<bool> keeps) {
        Row& row = table.rows.emplace_back();
        row.emplace_back(static_cast<long>(each.id));
        row.emplace_back(each.name);
        row.emplace_back(channel.name);
        row.emplace_back(channel.unit);
        row.emplace_back(value);
        addCell(row, change);
        addCell(row, keeps);
      };
      for (std::size_t p = 0; p < parameters_.size(); ++p) tell(parameters_[p], each.parameters[p], {}, {});
      for (std::size_t column = 0; column < columns_.size() && !each.failed(); ++column) {
        const double value = each.metrics[column];
        std::optional<double> change;
        if (base_ != nullptr && base_->metrics[column] != 0.0) change = changeOf(value, base_->metrics[column]);
        std::optional<bool> keeps;
        if (!broken_by_[column].empty()) keeps = !breaksLimit(column, value);
        tell(columns_[column].channel, value, change, keeps);
      }
    }
    return table;
  }

  /// One line a design: parameters, objectives, and the metrics where they are few.
  Table designs(std::string name, const std::vector<JudgedDesign>& list, bool judged) const {
    Table table{std::move(name), {{"design", ""}, {"name", ""}}, {}, 2};
    if (for_eyes_ && judged) table.columns.push_back({"limits", ""});
    for (std::size_t p = 0; p < parameters_.size(); ++p) {
      table.columns.push_back({parameters_[p].name, parameter_units_[p].name});
    }
    const bool with_metrics = columns_.size() <= kMostMetricColumns || bound_.objectives.empty() || !for_eyes_;
    for (const BoundObjective& each : bound_.objectives) {
      if (!with_metrics) table.columns.push_back({nameOf(each), metric_units_[each.metric].name});
    }
    for (std::size_t column = 0; column < columns_.size() && with_metrics; ++column) {
      table.columns.push_back({columns_[column].channel.name, unitOf(column).name});
    }
    if (!for_eyes_) table.columns.push_back({"limits", ""});
    for (const JudgedDesign& each : list) {
      Row& row = table.rows.emplace_back();
      row.emplace_back(static_cast<long>(each.id));
      row.emplace_back(each.name);
      const std::string verdict = each.failed() ? "failed" : each.keepsLimits() ? "kept" : "broken";
      if (for_eyes_ && judged) row.emplace_back(verdict);
      for (std::size_t p = 0; p < parameters_.size(); ++p) {
        row.emplace_back(each.parameters[p] * parameter_units_[p].factor);
      }
      for (std::size_t i = 0; i < bound_.objectives.size() && !with_metrics; ++i) {
        std::optional<double> value;
        if (!each.failed()) value = each.objectives[i] * metric_units_[bound_.objectives[i].metric].factor;
        addCell(row, value);
      }
      for (std::size_t column = 0; column < columns_.size() && with_metrics; ++column) {
        if (for_eyes_) {
          row.emplace_back(eyesOn(column, each));
        } else if (each.failed()) {
          row.emplace_back();
        } else {
          row.emplace_back(each.metrics[column]);
        }
      }
      if (!for_eyes_) row.emplace_back(verdict);
    }
    return table;
  }

  void front(Document& made) const {
    if (bound_.objectives.size() < 2) return;
    std::vector<JudgedDesign> shown = summary_.front;
    if (for_eyes_ && shown.size() > kMostInFront) {
      shown.clear();
      for (std::size_t i = 0; i < kMostInFront; ++i) {
        shown.push_back(summary_.front[i * (summary_.front.size() - 1) / (kMostInFront - 1)]);
      }
      made.remarks.push_back(fmt::format("the Pareto front has {} designs; {} of them are shown, evenly spaced",
                                         summary_.front.size(), kMostInFront));
    }
    made.tables.push_back(designs("Pareto front", shown, false));
  }

  void failures(Document& made) const {
    Table table{"failed designs", {{"design", ""}, {"name", ""}, {"why", ""}}, {}};
    for (const JudgedDesign& each : summary_.failures) {
      Row& row = table.rows.emplace_back();
      row.emplace_back(static_cast<long>(each.id));
      row.emplace_back(each.name);
      row.emplace_back(each.message);
    }
    made.tables.push_back(std::move(table));
    if (summary_.failed > summary_.failures.size()) {
      made.remarks.push_back(fmt::format("{} designs failed; the first {} are shown", summary_.failed,
                                         summary_.failures.size()));
    }
  }

  const StudySummary& summary_;
  const BoundStudy& bound_;
  std::vector<MetricColumn> columns_;
  std::vector<Channel> parameters_;
  std::vector<ShownUnit> parameter_units_;  // (parameters)
  std::vector<ShownUnit> metric_units_;     // (metrics)
  bool for_eyes_;
  std::vector<std::vector<std::size_t>> broken_by_;  // (columns) limits on each
  const JudgedDesign* base_ = nullptr;
};

}  // namespace

Document documentOf(const StudySummary& summary, const StudyInputs& inputs, Format format) {
  return Tables(summary, inputs, format).document();
}

}  // namespace vehicle::cli
