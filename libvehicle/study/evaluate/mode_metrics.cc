#include "libvehicle/study/evaluate/mode_metrics.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/linear/undamped.h"
#include "libvehicle/simulate/forms.h"

namespace vehicle {

namespace {

constexpr const char* kGeneralForm = "matrix";  // takes any topology

std::vector<MetricPlace> modeMetricsOf(const StudyInputs& inputs) {
  std::vector<MetricPlace> metrics;
  const std::vector<MetricColumn> columns = metricColumns(inputs.bound);
  for (std::size_t place = 0; place < columns.size(); ++place) {
    const Metric& metric = inputs.bound.metrics[columns[place].metric].metric;
    if (metric.kind == MetricKind::kMode) metrics.push_back({metric, place});
  }
  return metrics;
}

std::vector<std::string> namesOf(const ModeFollower& follower) {
  std::vector<std::string> names;
  for (const WholeMode& each : follower.modes()) names.push_back(each.names.front());
  return names;
}

}  // namespace

ModeMetrics::ModeMetrics(const StudyInputs& inputs)
    : inputs_(inputs), metrics_(modeMetricsOf(inputs)), vehicle_(inputs.vehicle), scenarios_(inputs.scenarios) {
  for (const StudyParameter& each : inputs.bound.parameters) base_values_.push_back(each.base);
  if (!metrics_.empty()) form_ = defaultForm(topologyOf(inputs.vehicle));
}

ModeMetrics::Model ModeMetrics::modelOf(std::span<const double> values, const std::string& form) {
  apply(inputs_.bound, values, vehicle_, scenarios_);
  const std::unique_ptr<System> system = buildForm(form, compile(vehicle_, scenarios_.front().gravity));
  return {system->linear().value().A, system->states()};
}

const ModeMetrics::Base& ModeMetrics::baseIn(const std::string& form) {
  const auto found = std::find_if(bases_.begin(), bases_.end(), [&](const auto& each) { return each->form == form; });
  if (found != bases_.end()) return **found;
  Model model = modelOf(base_values_, form);
  ModeFollower follower(model.A, model.states);
  bases_.push_back(std::make_unique<Base>(Base{std::move(model), form, std::move(follower)}));
  return *bases_.back();
}

void ModeMetrics::evaluate(std::size_t row, DesignRows& rows) {
  const std::span<const double> values = rows.parameters(row);
  Model design;
  const Base* chosen = &baseIn(form_);
  try {
    design = modelOf(values, form_);
  } catch (const InvalidInput&) {
    if (form_ == kGeneralForm) throw;
  }
  if (design.states != chosen->states) {  // a design may leave what the base's form can say
    chosen = &baseIn(kGeneralForm);
    design = modelOf(values, kGeneralForm);
  }
  try {
    write(row, *chosen, design, rows);
  } catch (const std::runtime_error& error) {  // an eigenvalue iteration that does not converge
    for (const MetricPlace& each : metrics_) rows.leaveEmpty(row, each.place, error.what());
  }
}

void ModeMetrics::write(std::size_t row, const Base& base, const Model& design, DesignRows& rows) {
  // Straight from matrix to matrix: what a mode is called depends on the two systems alone, not on what was varied.
  const std::vector<FollowedMode> followed =
      base.follower.follow([&](double t) -> Eigen::MatrixXd { return (1.0 - t) * base.A + t * design.A; });
  std::vector<UndampedMode> undamped;
  for (const MetricPlace& each : metrics_) {
    const std::optional<std::size_t> mode = base.follower.find(each.metric.subject);
    if (!mode) {
      rows.leaveEmpty(row, each.place, unknownName("mode", each.metric.subject, namesOf(base.follower)));
      continue;
    }
    const FollowedMode& found = followed[*mode];
    std::optional<double> value;
    std::string why = found.whyNoFrequency();
    if (each.metric.quantity == "undamped_frequency") {
      if (undamped.empty()) undamped = undampedModesOf(design.A, design.states);
      value = undampedFrequencyOf(found.roots, undamped);
      if (found.fate != FollowedMode::Fate::kLost) why = "its roots are not those of one undamped oscillation";
    } else if (each.metric.quantity == "damping") {
      value = found.dampingRatio();
    } else {
      value = each.metric.quantity == "frequency" ? found.frequency() : found.dampedFrequency();
    }
    if (value) {
      rows.metric(row, each.place) = *value;
    } else {
      rows.leaveEmpty(row, each.place, std::move(why));
    }
  }
}

Warnings ModeMetrics::unknownModes() {
  Warnings warnings;
  if (metrics_.empty()) return warnings;
  const ModeFollower& follower = baseIn(form_).follower;
  for (const StudyMetric& each : inputs_.study.metrics) {
    const std::optional<Metric> metric = parseMetric(each.name).metric;
    if (!metric || metric->kind != MetricKind::kMode || follower.find(metric->subject)) continue;
    const std::string unknown = unknownName("mode", metric->subject, namesOf(follower));
    const std::size_t remedy = unknown.find("; ");
    Warning warning;
    warning.code = WarningCode::kUnknownMode;
    warning.place = each.origin;
    warning.subject = metric->name;
    warning.message =
        unknown.substr(0, remedy) + " in the vehicle as its file says it: the metric has no value in any design";
    if (remedy != std::string::npos) warning.remedy = unknown.substr(remedy + 2);
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

Warnings unknownModes(const StudyInputs& inputs) { return ModeMetrics(inputs).unknownModes(); }

}  // namespace vehicle
