#include "libvehicle/model/bind_metrics.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "libvehicle/definition/judge.h"
#include "libvehicle/model/layout.h"

namespace vehicle {

namespace {

std::optional<Dimension> dimensionOf(std::string_view si_unit) {
  for (int i = 0; i <= static_cast<int>(Dimension::kAngularAcceleration); ++i) {
    const auto dimension = static_cast<Dimension>(i);
    if (describe(dimension).siUnit == si_unit) return dimension;
  }
  return std::nullopt;
}

class MetricBinder {
 public:
  MetricBinder(const Study& study, const Vehicle& vehicle, BoundStudy& bound, ProblemList& problems)
      : study_(study), vehicle_(vehicle), bound_(bound), problems_(problems) {}

  void run() {
    const Topology topology = topologyOf(vehicle_);
    std::vector<std::string> columns;
    std::vector<std::string> at_rest;  // what .deflection and .load may be asked of
    const std::vector<Channel> channels = resultChannels(topology);
    for (const Channel& each : channels) columns.push_back(each.name);
    for (const TopologySuspension& each : topology.suspensions) at_rest.push_back(each.name);
    for (const TopologyWheelset& each : topology.wheelsets) at_rest.push_back(each.name);
    for (const StudyMetric& each : study_.metrics) {
      Judge judge(problems_, "<study><metric>", "", each.origin);
      const std::optional<Metric> metric = parseMetric(each.name).metric;
      if (!metric) continue;
      const std::size_t before = problems_.size();
      std::string_view unit;
      if (metric->kind == MetricKind::kColumn) {
        const auto found = std::find(columns.begin(), columns.end(), metric->subject);
        if (found == columns.end()) {
          judge.say(
              written("name", each.name) + " asks for a column that the vehicle \"" + vehicle_.name + "\" has not",
              orNearest(metric->subject, columns, "columns are PART.QUANTITY, e.g. "));
        } else {
          unit = channels[static_cast<std::size_t>(found - columns.begin())].unit;
        }
      } else if (metric->kind == MetricKind::kStatic) {
        judgeStatic(*metric, topology.suspensions.size(), at_rest, judge);
      }
      bound_.metrics.push_back({*metric, unitOf(*metric, unit), metric->kind == MetricKind::kColumn});
      if (problems_.size() > before) wrong_.insert(metric->name);
    }
    bindGoals();
  }

 private:
  static std::string orNearest(const std::string& word, const std::vector<std::string>& names,
                               const std::string& else_) {
    const std::optional<std::string> nearest = nearestName(word, names);
    return nearest ? "did you mean \"" + *nearest + "\"?" : else_ + names.front();
  }

  static void judgeStatic(const Metric& metric, std::size_t suspensions, const std::vector<std::string>& at_rest,
                          Judge& judge) {
    const auto found = std::find(at_rest.begin(), at_rest.end(), metric.subject);
    const bool is_suspension = static_cast<std::size_t>(found - at_rest.begin()) < suspensions;
    if (found == at_rest.end()) {
      judge.say(written("name", metric.name) + " names no suspension or wheelset",
                orNearest(metric.subject, at_rest, "e.g. static.NAME." + metric.quantity + " of "));
    } else if (metric.quantity == "deflection" && !is_suspension) {
      judge.say(written("name", metric.name) + " asks for the deflection of a wheelset", "name a suspension");
    }
  }

  /// Its place among the metrics; nothing for one that is wrong or left out, which is reported already.
  [[nodiscard]] std::optional<std::size_t> metricNamed(const std::string& name) const {
    const auto found = std::find_if(bound_.metrics.begin(), bound_.metrics.end(),
                                    [&](const BoundMetric& each) { return each.metric.name == name; });
    if (found == bound_.metrics.end() || wrong_.contains(name)) return std::nullopt;
    return static_cast<std::size_t>(found - bound_.metrics.begin());
  }

  void bindGoals() {
    for (const Objective& each : study_.objectives) {
      if (const auto metric = metricNamed(each.metric)) bound_.objectives.push_back({*metric, each.goal, each.over});
    }
    for (const Limit& each : study_.limits) {
      Judge judge(problems_, "<study><limit>", each.metric, each.origin);
      const std::optional<std::size_t> metric = metricNamed(each.metric);
      if (!metric) continue;
      BoundLimit limit{*metric, {}, {}};
      const std::optional<Dimension> dimension = dimensionOf(bound_.metrics[limit.metric].unit);
      if (!dimension) continue;
      if (!each.below.empty()) limit.below = judge.quantity("below", each.below, *dimension);
      if (!each.above.empty()) limit.above = judge.quantity("above", each.above, *dimension);
      if (limit.below && limit.above && !(*limit.above < *limit.below)) {
        judge.say(written("above", each.above) + " is not under " + written("below", each.below),
                  "what may be lies between them: above=\"LOWER\" below=\"HIGHER\"");
      }
      bound_.limits.push_back(limit);
    }
  }

  const Study& study_;
  const Vehicle& vehicle_;
  BoundStudy& bound_;
  ProblemList& problems_;
  std::set<std::string> wrong_;  // names of metrics that the vehicle cannot give
};

}  // namespace

void bindMetrics(const Study& study, const Vehicle& vehicle, BoundStudy& bound, ProblemList& problems) {
  MetricBinder(study, vehicle, bound, problems).run();
}

}  // namespace vehicle
