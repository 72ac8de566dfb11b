#include "libvehicle/simulate/run_warnings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace vehicle {

namespace {

class Ranges {
 public:
  Ranges(const std::vector<Channel>& columns, const std::vector<ColumnSummary>& summaries)
      : columns_(columns), summaries_(summaries) {
    for (std::size_t i = 0; i < columns.size(); ++i) places_.emplace(columns[i].name, i);
  }

  void requirePushing(const std::string& column) {
    const ColumnSummary* found = summaryOf(column);
    // What rounding leaves of a load that just reaches 0 is no pull.
    if (found == nullptr || !(found->lowest < -1e-9 * found->peak())) return;
    Warning warning = make(WarningCode::kWheelLoad, column, found->lowest, found->lowest_at);
    warning.message =
        fmt::format("falls to {:.4g} kN at t = {:.5g} s; a rail only pushes, and this contact cannot open",
                    found->lowest / 1e3, found->lowest_at);
    warning.remedy = "the result from there on is not that of a vehicle; run slower or over a smaller irregularity";
    add(-found->lowest, std::move(warning));
  }

  void requireWithin(const std::string& column, double most, const char* what) {
    const ColumnSummary* found = summaryOf(column);
    if (found == nullptr || !(found->peak() > most)) return;
    const double value = -found->lowest > found->highest ? found->lowest : found->highest;
    Warning warning = make(WarningCode::kLargeMotion, column, value, found->peakAt());
    warning.message = fmt::format("reaches {:.4g} {} at t = {:.5g} s; {} beyond {:g} {}", value, warning.unit,
                                  found->peakAt(), what, most, warning.unit);
    warning.remedy = "check the input: no railway vehicle moves so far";
    add(found->peak() / most, std::move(warning));
  }

  Warnings take() {
    std::stable_sort(found_.begin(), found_.end(), [](const Found& a, const Found& b) {
      return a.warning.code != b.warning.code ? a.warning.code < b.warning.code : a.size > b.size;
    });
    Warnings warnings;
    for (Found& each : found_) warnings.push_back(std::move(each.warning));
    return warnings;
  }

 private:
  struct Found {
    double size = 0.0;  // how far outside, among warnings of one code
    Warning warning;
  };

  [[nodiscard]] const ColumnSummary* summaryOf(const std::string& column) const {
    const auto found = places_.find(column);
    return found == places_.end() ? nullptr : &summaries_[found->second];
  }

  [[nodiscard]] Warning make(WarningCode code, const std::string& column, double value, double time) const {
    Warning warning;
    warning.code = code;
    warning.subject = column;
    warning.value = value;
    warning.unit = columns_[places_.at(column)].unit;
    warning.time = time;
    return warning;
  }

  void add(double size, Warning warning) { found_.push_back({size, std::move(warning)}); }

  const std::vector<Channel>& columns_;
  const std::vector<ColumnSummary>& summaries_;
  std::map<std::string_view, std::size_t> places_;
  std::vector<Found> found_;
};

}  // namespace

Warnings rangeWarnings(const Topology& topology, const std::vector<Channel>& columns,
                       const std::vector<ColumnSummary>& summaries, double gravity) {
  if (summaries.size() != columns.size()) return {};
  Ranges ranges(columns, summaries);
  for (const TopologyWheelset& wheelset : topology.wheelsets) {
    if (gravity > 0.0) ranges.requirePushing(wheelset.name + ".load");
  }
  for (const TopologyBody& body : topology.bodies) {
    ranges.requireWithin(body.name + ".pitch", kMostPitch, "linear kinematics do not hold");
  }
  for (const TopologySuspension& suspension : topology.suspensions) {
    ranges.requireWithin(suspension.name + ".deflection", kMostTravel, "no railway spring has a travel");
  }
  return ranges.take();
}

}  // namespace vehicle
