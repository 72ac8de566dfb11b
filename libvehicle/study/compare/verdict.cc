#include "libvehicle/study/compare/verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vehicle {

Verdict::Verdict(const BoundStudy& study)
    : objectives_(study.objectives), limits_(study.limits), columns_(study.metrics.size()) {
  const std::vector<MetricColumn> columns = metricColumns(study);
  for (std::size_t i = 0; i < columns.size(); ++i) columns_[columns[i].metric].push_back(i);
}

std::vector<double> Verdict::objectives(std::span<const double> metrics) const {
  std::vector<double> values;
  for (const BoundObjective& objective : objectives_) {
    const std::vector<std::size_t>& columns = columns_[objective.metric];
    double sum = 0.0;
    for (const std::size_t column : columns) sum += metrics[column];  // NaN where any of them is missing
    if (objective.over == Over::kMean) {
      values.push_back(sum / static_cast<double>(columns.size()));
    } else {
      values.push_back(std::isnan(sum) ? sum : metrics[*worstColumn(objective, metrics)]);
    }
  }
  return values;
}

std::optional<std::size_t> Verdict::worstColumn(const BoundObjective& objective,
                                                std::span<const double> metrics) const {
  std::optional<std::size_t> worst;
  for (const std::size_t column : columns_[objective.metric]) {
    const double value = metrics[column];
    if (std::isnan(value)) return std::nullopt;
    const bool worse =
        !worst || (objective.goal == Goal::kMinimise ? value > metrics[*worst] : value < metrics[*worst]);
    if (worse) worst = column;
  }
  return worst;
}

std::vector<double> Verdict::toMinimise(std::span<const double> metrics) const {
  std::vector<double> values = objectives(metrics);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (objectives_[i].goal == Goal::kMaximise) values[i] = -values[i];
  }
  return values;
}

std::vector<double> Verdict::violations(std::span<const double> metrics) const {
  std::vector<double> all;
  for (const BoundLimit& limit : limits_) {
    double worst = 0.0;
    for (const std::size_t column : columns_[limit.metric]) {
      if (std::isnan(metrics[column])) worst = std::numeric_limits<double>::infinity();
      if (limit.below) worst = std::max(worst, metrics[column] - *limit.below);
      if (limit.above) worst = std::max(worst, *limit.above - metrics[column]);
    }
    all.push_back(worst);
  }
  return all;
}

bool Verdict::keepsLimits(std::span<const double> metrics) const {
  const std::vector<double> all = violations(metrics);
  return std::all_of(all.begin(), all.end(), [](double each) { return each == 0.0; });
}

}  // namespace vehicle
