#include "libvehicle/report/run/sharing_tables.h"

#include <string>

#include "libvehicle/partition/scheme.h"

namespace vehicle::report {
namespace {

/// Nothing where it was not found out.
Cell nanoseconds(double seconds) { return seconds > 0.0 ? Cell(1e9 * seconds) : Cell(); }

}  // namespace

std::vector<Fact> sharingFacts(const RunResult& result) {
  std::vector<Fact> facts = {{"scheme", result.scheme, ""}, {"threads", static_cast<long>(result.threads), ""}};
  if (!result.decision.reason.empty()) {
    facts.push_back({"chosen because", result.decision.reason, ""});
    facts.push_back({"calibration", 1e3 * result.decision.calibration, "ms"});
  }
  return facts;
}

Table decisionTable(const Decision& decision) {
  Table table{"ways to run it",
              {{"scheme", ""}, {"threads", ""}, {"predicted", "ns/step"}, {"measured", "ns/step"}, {"taken", ""}},
              {},
              2};
  if (decision.reason.empty()) return table;
  for (const Candidate& each : decision.candidates) {
    table.rows.push_back({std::string(nameOf(each.scheme)), static_cast<long>(each.threads),
                          nanoseconds(each.predicted), nanoseconds(each.measured),
                          each.scheme == decision.scheme && each.threads == decision.threads});
  }
  return table;
}

}  // namespace vehicle::report
