#include "libvehicle/simulate/run_warnings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace vehicle {

namespace {

class Ranges {
 public:
  Ranges(const OutputLayout& layout, const std::vector<ColumnSummary>& summaries)
      : layout_(layout), summaries_(summaries) {}

  void requirePushing(std::size_t column) {
    const ColumnSummary& found = summaries_[column];
    // What rounding leaves of a load that just reaches 0 is no pull.
    if (!(found.lowest < -1e-9 * found.peak())) return;
    Warning warning = make(WarningCode::kWheelLoad, column, found.lowest, found.lowest_at);
    warning.message =
        fmt::format("falls to {:.4g} kN at t = {:.5g} s; a rail only pushes, and this contact cannot open",
                    found.lowest / 1e3, found.lowest_at);
    warning.remedy = "the result from there on is not that of a vehicle; run slower or over a smaller irregularity";
    add(-found.lowest, std::move(warning));
  }

  void requireWithin(std::size_t column, double most, const char* what) {
    const ColumnSummary& found = summaries_[column];
    if (!(found.peak() > most)) return;
    const double value = -found.lowest > found.highest ? found.lowest : found.highest;
    Warning warning = make(WarningCode::kLargeMotion, column, value, found.peakAt());
    warning.message = fmt::format("reaches {:.4g} {} at t = {:.5g} s; {} beyond {:g} {}", value, warning.unit,
                                  found.peakAt(), what, most, warning.unit);
    warning.remedy = "check the input: no railway vehicle moves so far";
    add(found.peak() / most, std::move(warning));
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

  [[nodiscard]] Warning make(WarningCode code, std::size_t column, double value, double time) const {
    Warning warning;
    warning.code = code;
    warning.subject = layout_.channels()[column].name;
    warning.value = value;
    warning.unit = layout_.channels()[column].unit;
    warning.time = time;
    return warning;
  }

  void add(double size, Warning warning) { found_.push_back({size, std::move(warning)}); }

  const OutputLayout& layout_;
  const std::vector<ColumnSummary>& summaries_;
  std::vector<Found> found_;
};

}  // namespace

Warnings rangeWarnings(const OutputLayout& layout, const std::vector<ColumnSummary>& summaries, double gravity) {
  if (summaries.size() != layout.keys().size()) return {};
  Ranges ranges(layout, summaries);
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const OutputKey& key = layout.keys()[i];
    if (key.quantity == Quantity::kLoad && gravity > 0.0) ranges.requirePushing(i);
    if (key.quantity == Quantity::kPitch) ranges.requireWithin(i, kMostPitch, "linear kinematics do not hold");
    if (key.quantity == Quantity::kDeflection) {
      ranges.requireWithin(i, kMostTravel, "no railway spring has a travel");
    }
  }
  return ranges.take();
}

}  // namespace vehicle
