#include "libvehicle/validation/overall.h"

#include <algorithm>

#include <fmt/format.h>

#include "libvehicle/diagnostics/warning_collector.h"

namespace vehicle {

std::string caseName(const ValidationReport& report) {
  return fmt::format("{} on {} at {:.4g} km/h", report.vehicle, report.scenario, 3.6 * report.speed);
}

Warnings warningsOf(const std::vector<ValidationReport>& reports, bool has_several) {
  WarningCollector collector;
  for (const ValidationReport& each : reports) {
    collector.add(each.warnings, has_several ? caseName(each) : std::string());
  }
  return collector.take();
}

Overall overallOf(const std::vector<ValidationReport>& reports, Unjudged unjudged) {
  const auto any = [&](const auto& is) { return std::any_of(reports.begin(), reports.end(), is); };
  if (any([](const ValidationReport& each) { return each.failed(); })) return Overall::kFailed;
  if (any([](const ValidationReport& each) { return each.count(Verdict::kOutside) > 0; })) return Overall::kDoesNotHold;
  if (any([](const ValidationReport& each) { return each.stopped; })) return Overall::kInterrupted;
  if (!any([](const ValidationReport& each) { return each.count(Verdict::kInside) > 0; })) return Overall::kDoesNotHold;
  if (unjudged == Unjudged::kAccept) return Overall::kHolds;
  const bool all_inside = !any([](const ValidationReport& each) { return !each.inside(); });
  return all_inside ? Overall::kHolds : Overall::kDoesNotHold;
}

}  // namespace vehicle
