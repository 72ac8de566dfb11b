#include "libvehicle/report/study/study_columns.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace vehicle::report {

StudyColumns::StudyColumns(const StudySummary& summary, const StudyInputs& inputs, Format format)
    : bound_(inputs.bound),
      columns_(metricColumns(inputs.bound)),
      parameters_(parameterColumns(inputs.bound)),
      formatted_(format == Format::kTable),
      limits_on_(columns_.size()) {
  for (std::size_t limit = 0; limit < bound_.limits.size(); ++limit) {
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      if (columns_[column].metric == bound_.limits[limit].metric) limits_on_[column].push_back(limit);
    }
  }
  if (!summary.compared.empty() && summary.compared.front().id == 0 && !summary.compared.front().failed()) {
    base_ = &summary.compared.front();
  }
  chooseUnits(summary);
}

/// One unit a parameter and one a metric, the same in every table; SI for other programs.
void StudyColumns::chooseUnits(const StudySummary& summary) {
  std::vector<double> largest(parameters_.size() + bound_.metrics.size(), 0.0);
  const auto see = [&](const JudgedDesign& each) {
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
      largest[i] = std::max(largest[i], std::abs(each.parameters[i]));
    }
    for (std::size_t i = 0; i < each.metrics.size(); ++i) {
      if (std::isnan(each.metrics[i])) continue;
      double& own = largest[parameters_.size() + columns_[i].metric];
      own = std::max(own, std::abs(each.metrics[i]));
    }
  };
  if (formatted_) std::for_each(summary.compared.begin(), summary.compared.end(), see);
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    parameter_units_.push_back(shownUnit(parameters_[i].unit, largest[i], Velocity::kOfTravel));
  }
  for (std::size_t i = 0; i < bound_.metrics.size(); ++i) {
    metric_units_.push_back(shownUnit(bound_.metrics[i].unit, largest[parameters_.size() + i]));
  }
}

std::vector<TableColumn> StudyColumns::head() const {
  if (formatted_) return {{"design", ""}};
  return {{"id", ""}, {"design", ""}};
}

void StudyColumns::addHead(const JudgedDesign& design, Row& row) const {
  if (!formatted_) row.emplace_back(static_cast<long>(design.id));
  row.emplace_back(design.name);
}

std::size_t StudyColumns::casesOf(const BoundObjective& objective) const {
  return static_cast<std::size_t>(std::count_if(
      columns_.begin(), columns_.end(), [&](const MetricColumn& each) { return each.metric == objective.metric; }));
}

std::string StudyColumns::nameOf(const BoundObjective& objective) const {
  const std::string& name = bound_.metrics[objective.metric].metric.name;
  const std::size_t cases = casesOf(objective);
  if (cases < 2) return name;
  return fmt::format("{}, {} of {}", name, objective.over == Over::kMean ? "mean" : "worst", cases);
}

bool StudyColumns::hasWorst(const BoundObjective& objective) const {
  return objective.over == Over::kWorst && casesOf(objective) > 1;
}

std::optional<bool> StudyColumns::breaksLimit(std::size_t column, double value) const {
  const std::vector<std::size_t>& limits = limits_on_[column];
  if (limits.empty()) return std::nullopt;
  return std::any_of(limits.begin(), limits.end(), [&](std::size_t number) {
    const BoundLimit& limit = bound_.limits[number];
    return std::isnan(value) || (limit.below && value > *limit.below) || (limit.above && value < *limit.above);
  });
}

std::optional<double> StudyColumns::changeIn(std::size_t column, const JudgedDesign& design) const {
  if (base_ == nullptr) return std::nullopt;
  const double base = base_->metrics[column];
  // Of the base's size, so that it has the sign of the change where the base is negative.
  const double change =
      100.0 * (base < 0.0 ? 1.0 - design.metrics[column] / base : design.metrics[column] / base - 1.0);
  if (!std::isfinite(change)) return std::nullopt;
  return change;
}

std::string StudyColumns::textOf(std::size_t column, const JudgedDesign& design) const {
  if (design.failed()) return "failed";
  const double value = design.metrics[column];
  std::string text = std::isnan(value) ? "-" : fmt::format("{:.5g}", value * unitOf(column).factor + 0.0);
  if (const std::optional<double> change = changeIn(column, design); change && design.id != 0) {
    text += fmt::format(" ({:+.1f} %)", std::round(10.0 * *change) / 10.0 + 0.0);  // never -0.0
  }
  if (!bound_.limits.empty()) text += breaksLimit(column, value).value_or(false) ? " !" : "  ";
  return text;
}

void StudyColumns::addNumber(double value, Row& row) {
  if (std::isnan(value)) {
    row.emplace_back();
  } else {
    row.emplace_back(value);
  }
}

}  // namespace vehicle::report
