#include <algorithm>
#include <optional>

#include "libvehicle/ensemble/design.h"
#include "libvehicle/ensemble/isa.h"
#include "libvehicle/flat/flat_form.h"
#include "libvehicle/flat/flat_layout.h"
#include "libvehicle/model/topology.h"
#include "libvehicle/simulate/forms.h"
#include "libvehicle/simulate/methods.h"
#include "libvehicle/study/evaluate/path.h"

namespace vehicle {

namespace {

/// Why no lane of an ensemble can hold this study's designs; empty if it can.
std::string whyNotFlat(const StudyInputs& inputs, const Topology& topology) {
  if (inputs.vehicle.units.size() > 1) return "the ensemble's lanes hold one vehicle, this is a train";
  const ProblemList unsupported = flatUnsupported(topology, FlatVariant::kConsistent);
  if (!unsupported.empty()) return firstProblem(unsupported);
  const FlatLayout layout = readLayout(topology).layout;
  for (const BoundMetric& each : inputs.bound.metrics) {
    if (each.metric.kind != MetricKind::kColumn || flatColumn(topology, layout, each.metric.subject)) continue;
    return "the ensemble has no column " + each.metric.subject;
  }
  return {};
}

void requireSteady(const StudyInputs& inputs) {
  ProblemList problems;
  for (const Scenario& each : inputs.scenarios) {
    if (!each.track || !hasSingleFeatures(*each.track)) continue;
    problems.add({each.origin, "<scenario>",
                  "has a dip, bump or ramp, which is met once: the study asks for the steady state",
                  "leave evaluation=\"steady_state\" out, or name a scenario of harmonics"});
  }
  if (!problems.empty()) throw InvalidInput(std::move(problems));
}

std::string lanesText() {
  const Isa isa = bestIsa();
  return std::to_string(lanesOf(isa)) + " designs at once (" + std::string(nameOf(isa)) + ")";
}

}  // namespace

std::vector<ColumnRequest> requestsOf(const BoundStudy& bound, std::size_t study_case) {
  std::vector<ColumnRequest> requests;
  const std::vector<MetricColumn> columns = metricColumns(bound);
  for (std::size_t place = 0; place < columns.size(); ++place) {
    if (columns[place].study_case != study_case) continue;
    const Metric& metric = bound.metrics[columns[place].metric].metric;
    auto request = std::find_if(requests.begin(), requests.end(),
                                [&](const ColumnRequest& each) { return each.column == metric.subject; });
    if (request == requests.end()) request = requests.insert(requests.end(), {metric.subject, {}});
    request->entries.push_back({metric, place});
  }
  return requests;
}

void leaveEmpty(const std::vector<ColumnRequest>& requests, std::size_t design, const std::string& why,
                DesignRows& rows) {
  for (const ColumnRequest& request : requests) {
    for (const MetricPlace& entry : request.entries) rows.leaveEmpty(design, entry.place, why);
  }
}

std::string inCase(const StudyCase& study_case) { return study_case.label.empty() ? "" : " at " + study_case.label; }

Scenario steadyScenario(Scenario scenario) {
  if (scenario.track) {
    scenario.track->history = History::kExtended;
    scenario.track->fade_in.reset();
  }
  return scenario;
}

PathChoice choosePath(const StudyInputs& inputs) {
  using enum PathChoice::Kind;
  PathChoice choice;
  const Topology topology = topologyOf(inputs.vehicle);
  choice.why_not_flat = whyNotFlat(inputs, topology);
  const bool flat = choice.why_not_flat.empty();
  if (inputs.study.evaluation == Evaluation::kSteadyState) {
    requireSteady(inputs);
    choice.kind = flat ? kSteadyEnsemble : kSteadySingle;
    choice.text = flat ? "steady state in closed form, flat form, " + lanesText()
                       : "steady state in closed form, matrix form, design by design: " + choice.why_not_flat;
    return choice;
  }
  choice.kind = flat ? kEnsembleRuns : kSingleRuns;
  if (flat) {
    choice.text = "runs by rk4 with steps of 1 ms or less, as the fastest motion asks, flat form, " + lanesText();
  } else {
    const std::string form = defaultForm(topology);
    choice.text =
        "runs by " + defaultMethod(form, topology) + ", " + form + " form, design by design: " + choice.why_not_flat;
  }
  return choice;
}

std::unique_ptr<Path> makePath(const StudyInputs& inputs, PathChoice::Kind kind) {
  switch (kind) {
    case PathChoice::Kind::kSteadyEnsemble:
      return makeSteadyEnsemblePath(inputs);
    case PathChoice::Kind::kEnsembleRuns:
      return makeEnsembleRunPath(inputs);
    case PathChoice::Kind::kSteadySingle:
      return makeSteadySinglePath(inputs);
    case PathChoice::Kind::kSingleRuns:
      break;
  }
  return makeSingleRunPath(inputs);
}

}  // namespace vehicle
