#include "apps/cli/study_tables.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/study/compare/verdict.h"

namespace vehicle::cli {
namespace {

constexpr std::size_t kMostInFront = 20;       // rows of a front for eyes
constexpr std::size_t kMostAsColumns = 6;      // designs side by side
constexpr std::size_t kMostMetricColumns = 6;  // metrics of a design in one line

double changeOf(double value, double base) { return 100.0 * (value / base - 1.0); }

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
  }

  Document document() {
    Document made;
    compare(made);
    for (std::size_t i = 0; i < summary_.best.size(); ++i) {
      const BoundObjective& objective = bound_.objectives[i];
      const char* goal = objective.goal == Goal::kMinimise ? "smallest " : "largest ";
      made.tables.push_back(designs(goal + nameOf(objective), summary_.best[i]));
    }
    front(made);
    influences(made);
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

  bool breaksLimit(std::size_t column, double value) const {
    return std::any_of(broken_by_[column].begin(), broken_by_[column].end(), [&](std::size_t number) {
      const BoundLimit& limit = bound_.limits[number];
      return (limit.below && value > *limit.below) || (limit.above && value < *limit.above);
    });
  }

  Cell eyesOn(std::size_t column, const JudgedDesign& design) const {
    if (design.failed()) return std::string("failed");
    const double value = design.metrics[column];
    std::string text = fmt::format("{:.5g}", value);
    if (base_ != nullptr && &design != base_ && design.id != 0 && base_->metrics[column] != 0.0) {
      text += fmt::format(" ({:+.1f} %)", changeOf(value, base_->metrics[column]));
    }
    if (breaksLimit(column, value)) text += " !";
    return text;
  }

  void compare(Document& made) const {
    if (!for_eyes_) {
      made.tables.push_back(everyNumber());
    } else if (summary_.compared.size() <= kMostAsColumns) {
      made.tables.push_back(sideBySide());
    } else {
      made.tables.push_back(designs("designs", summary_.compared));
    }
    const bool marked = for_eyes_ && std::any_of(summary_.compared.begin(), summary_.compared.end(), [](const auto& each) {
      return !each.failed() && !each.keepsLimits();
    });
    if (marked) made.remarks.push_back("! breaks a limit");
  }

  /// Metrics below each other, one column a design.
  Table sideBySide() const {
    Table table{"comparison", {{"metric", ""}, {"unit", ""}}, {}};
    for (const JudgedDesign& each : summary_.compared) table.columns.push_back({each.name, ""});
    for (std::size_t p = 0; p < parameters_.size(); ++p) {
      std::vector<Cell> row{parameters_[p].name, parameters_[p].unit};
      for (const JudgedDesign& each : summary_.compared) row.emplace_back(each.parameters[p]);
      table.rows.push_back(std::move(row));
    }
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      std::vector<Cell> row{columns_[column].channel.name, columns_[column].channel.unit};
      for (const JudgedDesign& each : summary_.compared) row.push_back(eyesOn(column, each));
      table.rows.push_back(std::move(row));
    }
    return table;
  }

  /// One line a design and metric, for other programs.
  Table everyNumber() const {
    Table table{"comparison",
                {{"design", ""}, {"name", ""}, {"metric", ""}, {"unit", ""}, {"value", ""}, {"change", "%"},
                 {"keeps limit", ""}},
                {}};
    for (const JudgedDesign& each : summary_.compared) {
      for (std::size_t column = 0; column < columns_.size() && !each.failed(); ++column) {
        const double value = each.metrics[column];
        Cell change;
        if (base_ != nullptr && base_->metrics[column] != 0.0) change = changeOf(value, base_->metrics[column]);
        Cell keeps;
        if (!broken_by_[column].empty()) keeps = !breaksLimit(column, value);
        table.rows.push_back({static_cast<long>(each.id), each.name, columns_[column].channel.name,
                              columns_[column].channel.unit, value, change, keeps});
      }
    }
    return table;
  }

  /// One line a design: parameters, objectives, and the metrics where they are few.
  Table designs(std::string name, const std::vector<JudgedDesign>& list) const {
    Table table{std::move(name), {{"design", ""}, {"name", ""}}, {}};
    for (const Channel& each : parameters_) table.columns.push_back({each.name, each.unit});
    const bool with_metrics = columns_.size() <= kMostMetricColumns || bound_.objectives.empty() || !for_eyes_;
    for (const BoundObjective& each : bound_.objectives) {
      if (!with_metrics) table.columns.push_back({nameOf(each), bound_.metrics[each.metric].unit});
    }
    for (const MetricColumn& each : columns_) {
      if (with_metrics) table.columns.push_back({each.channel.name, each.channel.unit});
    }
    table.columns.push_back({"limits", ""});
    for (const JudgedDesign& each : list) {
      std::vector<Cell> row{static_cast<long>(each.id), each.name};
      row.insert(row.end(), each.parameters.begin(), each.parameters.end());
      if (!with_metrics) {
        for (std::size_t i = 0; i < bound_.objectives.size(); ++i) {
          row.push_back(each.failed() ? Cell() : Cell(each.objectives[i]));
        }
      }
      for (std::size_t column = 0; column < columns_.size() && with_metrics; ++column) {
        row.push_back(for_eyes_ ? eyesOn(column, each) : each.failed() ? Cell() : Cell(each.metrics[column]));
      }
      row.push_back(std::string(each.failed() ? "failed" : each.keepsLimits() ? "kept" : "broken"));
      table.rows.push_back(std::move(row));
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
    made.tables.push_back(designs("Pareto front", shown));
  }

  void influences(Document& made) const {
    Table table{"what the factors do", {{"metric", ""}, {"factor", ""}}, {}};
    const bool indices = std::any_of(summary_.influences.begin(), summary_.influences.end(),
                                     [](const Influence& each) { return !each.indices.indices.empty(); });
    if (indices) {
      for (const char* name : {"first-order index", "95 % from", "to", "total index", "95 % from", "to"}) {
        table.columns.push_back({name, ""});
      }
    }
    for (const char* name : {"correlation", "regression"}) table.columns.push_back({name, ""});
    for (const Influence& each : summary_.influences) {
      for (std::size_t factor = 0; factor < bound_.factors.size(); ++factor) {
        std::vector<Cell> row{each.output, bound_.factors[factor].name};
        if (indices && each.indices.indices.empty()) row.resize(row.size() + 6);
        if (indices && !each.indices.indices.empty()) {
          const SensitivityIndex& index = each.indices.indices[factor];
          for (const Estimate& estimate : {index.first, index.total}) {
            row.insert(row.end(), {estimate.value, estimate.low, estimate.high});
          }
        }
        row.emplace_back(each.correlations[factor]);
        row.push_back(each.fit ? Cell(each.fit->coefficients[factor]) : Cell());
        table.rows.push_back(std::move(row));
      }
      if (each.fit) {
        made.remarks.push_back(
            fmt::format("{}: straight lines explain {:.1f} % of its variance", each.output, 100.0 * each.fit->explained));
      }
    }
    made.tables.push_back(std::move(table));
  }

  void failures(Document& made) const {
    Table table{"failed designs", {{"design", ""}, {"name", ""}, {"why", ""}}, {}};
    for (const JudgedDesign& each : summary_.failures) {
      table.rows.push_back({static_cast<long>(each.id), each.name, each.message});
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
  bool for_eyes_;
  std::vector<std::vector<std::size_t>> broken_by_;  // (columns) limits on each
  const JudgedDesign* base_ = nullptr;
};

}  // namespace

Document documentOf(const StudySummary& summary, const StudyInputs& inputs, Format format) {
  return Tables(summary, inputs, format).document();
}

}  // namespace vehicle::cli
