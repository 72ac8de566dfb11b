#include "libvehicle/model/bound_study.h"

#include <algorithm>
#include <cmath>

namespace vehicle {

double valueAt(const Factor& factor, double u) {
  if (!factor.levels.empty()) {
    const auto count = static_cast<double>(factor.levels.size());
    const auto level = static_cast<std::size_t>(std::max(0.0, std::floor(u * count)));
    return factor.levels[std::min(level, factor.levels.size() - 1)];
  }
  if (u <= 0.0) return factor.from;
  if (u >= 1.0) return factor.to;
  const double value = factor.spacing == Spacing::kLogarithmic ? factor.from * std::pow(factor.to / factor.from, u)
                                                               : factor.from + (factor.to - factor.from) * u;
  // Rounding must not lead out of the range.
  return std::clamp(value, std::min(factor.from, factor.to), std::max(factor.from, factor.to));
}

void apply(const BoundStudy& study, std::span<const double> values, Vehicle& vehicle,
           std::vector<Scenario>& scenarios) {
  for (std::size_t i = 0; i < study.parameters.size(); ++i) {
    const StudyParameter& parameter = study.parameters[i];
    if (parameter.in_vehicle) parameter.in_vehicle->setIn(vehicle, values[i]);
    for (std::size_t s = 0; s < parameter.in_scenarios.size(); ++s) {
      if (parameter.in_scenarios[s]) parameter.in_scenarios[s]->setIn(scenarios[s], values[i]);
    }
  }
}

std::vector<MetricColumn> metricColumns(const BoundStudy& study) {
  std::vector<MetricColumn> columns;
  for (std::size_t m = 0; m < study.metrics.size(); ++m) {
    const BoundMetric& bound = study.metrics[m];
    if (!bound.per_case) {
      columns.push_back({m, std::nullopt, {bound.metric.name, bound.unit}});
      continue;
    }
    for (std::size_t c = 0; c < study.cases.size(); ++c) {
      const std::string& label = study.cases[c].label;
      columns.push_back({m, c, {label.empty() ? bound.metric.name : bound.metric.name + " @ " + label, bound.unit}});
    }
  }
  return columns;
}

std::vector<Channel> parameterColumns(const BoundStudy& study) {
  std::vector<Channel> columns;
  for (const StudyParameter& each : study.parameters) {
    columns.push_back({each.address, std::string(describe(each.dimension).siUnit)});
  }
  return columns;
}

}  // namespace vehicle
