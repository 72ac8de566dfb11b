#include "libvehicle/study/evaluate/rest_and_modes.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "libvehicle/model/compiled_model.h"
#include "libvehicle/study/evaluate/flat_block.h"

namespace vehicle {

namespace {

template <class Part>
std::size_t placeOf(const std::vector<Part>& parts, const std::string& name) {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const Part& each) { return each.name == name; });
  return static_cast<std::size_t>(found - parts.begin());
}

}  // namespace

RestAndModes::RestAndModes(const StudyInputs& inputs)
    : inputs_(inputs), vehicle_(inputs.vehicle), scenarios_(inputs.scenarios), modes_(inputs) {
  const std::vector<MetricColumn> columns = metricColumns(inputs.bound);
  for (std::size_t place = 0; place < columns.size(); ++place) {
    const Metric& metric = inputs.bound.metrics[columns[place].metric].metric;
    if (metric.kind == MetricKind::kStatic) rest_.push_back({metric, place});
  }
}

void RestAndModes::evaluate(DesignRows& rows) {
  if (rest_.empty() && modes_.empty()) return;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (rows.failed(row)) continue;
    try {
      if (!rest_.empty()) evaluateRest(row, rows);
      if (!modes_.empty()) modes_.evaluate(row, rows);
    } catch (const std::runtime_error& error) {
      rows.fail(row, designProblem(error));
    } catch (const std::invalid_argument& error) {
      rows.fail(row, error.what());
    }
  }
}

void RestAndModes::evaluateRest(std::size_t row, DesignRows& rows) {
  apply(inputs_.bound, rows.parameters(row), vehicle_, scenarios_);
  const CompiledModel model = compile(vehicle_, scenarios_.front().gravity);
  const Topology& topology = model.topology;
  const Rest& rest = model.rest;
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

}  // namespace vehicle
