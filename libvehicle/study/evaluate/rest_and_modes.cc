#include "libvehicle/study/evaluate/rest_and_modes.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "libvehicle/linear/modes.h"
#include "libvehicle/simulate/forms.h"
#include "libvehicle/statics/rest.h"
#include "libvehicle/study/evaluate/flat_block.h"

namespace vehicle {

namespace {

template <class Part>
std::size_t placeOf(const std::vector<Part>& parts, const std::string& name) {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const Part& each) { return each.name == name; });
  return static_cast<std::size_t>(found - parts.begin());
}

std::vector<Mode> modesOfVehicle(const Vehicle& vehicle, double gravity) {
  return modesOf(*buildForm(defaultForm(vehicle), vehicle, gravity));
}

std::string modeMissing(const std::string& name, const std::vector<Mode>& modes) {
  std::vector<std::string> names;
  for (const Mode& mode : modes) names.push_back(mode.name);
  return unknownName("mode", name, names);
}

}  // namespace

RestAndModes::RestAndModes(const StudyInputs& inputs)
    : inputs_(inputs), vehicle_(inputs.vehicle), scenarios_(inputs.scenarios) {
  const std::vector<MetricColumn> columns = metricColumns(inputs.bound);
  for (std::size_t place = 0; place < columns.size(); ++place) {
    const Metric& metric = inputs.bound.metrics[columns[place].metric].metric;
    if (metric.kind == MetricKind::kStatic) rest_.push_back({metric, place});
    if (metric.kind == MetricKind::kMode) modes_.push_back({metric, place});
  }
}

void RestAndModes::evaluate(DesignRows& rows) {
  if (rest_.empty() && modes_.empty()) return;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (rows.failed(row)) continue;
    apply(inputs_.bound, rows.parameters(row), vehicle_, scenarios_);
    const double gravity = scenarios_.front().gravity;
    try {
      if (!rest_.empty()) evaluateRest(row, gravity, rows);
      if (!modes_.empty() && !rows.failed(row)) evaluateModes(row, gravity, rows);
    } catch (const std::runtime_error& error) {
      rows.fail(row, designProblem(error));
    } catch (const std::invalid_argument& error) {
      rows.fail(row, error.what());
    }
  }
}

void RestAndModes::evaluateRest(std::size_t row, double gravity, DesignRows& rows) const {
  const Topology topology = topologyOf(vehicle_);
  const Rest rest = restOf(topology, gravity);
  for (const MetricPlace& each : rest_) {
    const std::size_t suspension = placeOf(topology.suspensions, each.metric.subject);
    double& value = rows.metric(row, each.place);
    if (suspension == topology.suspensions.size()) {
      value = rest.wheel_load[placeOf(topology.wheelsets, each.metric.subject)];  // bindStudy() knows it
    } else if (each.metric.quantity == "load") {
      value = rest.suspension_load[suspension];
    } else if (topology.suspensions[suspension].stiffness > 0.0) {
      value = rest.suspension_load[suspension] / topology.suspensions[suspension].stiffness;
    } else {
      rows.leaveEmpty(row, each.place, "it has no stiffness, so no deflection at rest");
    }
  }
}

void RestAndModes::evaluateModes(std::size_t row, double gravity, DesignRows& rows) const {
  const std::vector<Mode> modes = modesOfVehicle(vehicle_, gravity);
  for (const MetricPlace& each : modes_) {
    const std::size_t place = placeOf(modes, each.metric.subject);
    if (place == modes.size()) return rows.fail(row, modeMissing(each.metric.subject, modes));
    rows.metric(row, each.place) =
        each.metric.quantity == "frequency" ? modes[place].frequency : modes[place].damping_ratio;
  }
}

std::vector<std::string> modesInDoubt(const StudyInputs& inputs) {
  std::vector<std::string> doubts;
  std::vector<Mode> modes;
  for (const BoundMetric& each : inputs.bound.metrics) {
    const Metric& metric = each.metric;
    if (metric.kind != MetricKind::kMode) continue;
    if (modes.empty()) modes = modesOfVehicle(inputs.vehicle, inputs.scenarios.front().gravity);
    if (placeOf(modes, metric.subject) < modes.size()) continue;
    doubts.push_back(fmt::format("metric {}: {} (in the vehicle as it stands; designs without that mode fail)",
                                 metric.name, modeMissing(metric.subject, modes)));
  }
  return doubts;
}

}  // namespace vehicle
