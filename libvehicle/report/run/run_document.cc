#include "libvehicle/report/run/run_document.h"

#include <utility>

#include "libvehicle/report/run/history_table.h"
#include "libvehicle/report/run/sharing_tables.h"

namespace vehicle::report {
namespace {

Table runTable(const std::vector<RunResult>& runs) {
  Table table{"runs",
              {{"speed", "m/s"},
               {"end of run", "s"},
               {"samples", ""},
               {"steps", ""},
               {"evaluations", ""},
               {"rejected steps", ""},
               {"run time", "s"}},
              {}};
  for (const RunResult& each : runs) {
    table.rows.push_back({each.speed, each.reached, each.outputs, each.statistics.steps, each.statistics.evaluations,
                          each.statistics.rejected, each.wall_seconds});
  }
  return table;
}

}  // namespace

std::vector<Fact> factsOf(const RunNames& names) {
  return {{"vehicle", names.vehicle, ""},
          {"scenario", names.scenario, ""},
          {"form", names.form, ""},
          {"method", names.method, ""}};
}

std::vector<Fact> factsOf(const RunNames& names, double speed) {
  std::vector<Fact> facts = factsOf(names);
  facts.push_back({"speed", speed, "m/s"});
  return facts;
}

Document documentOf(const RunNames& names, const RunResult& result, Format format) {
  Document document;
  document.facts = factsOf(names, result.speed);
  for (Fact& fact : sharingFacts(result)) document.facts.push_back(std::move(fact));
  document.facts.insert(document.facts.end(), {{"end of run", result.reached, "s"},
                                               {"samples", result.outputs, ""},
                                               {"steps", result.statistics.steps, ""},
                                               {"evaluations", result.statistics.evaluations, ""},
                                               {"rejected steps", result.statistics.rejected, ""},
                                               {"run time", result.wall_seconds, "s"}});
  document.tables = {decisionTable(result.decision), historyTable(result.history.columns(), result.summaries, format)};
  return document;
}

Document documentOf(const RunNames& names, const std::vector<RunResult>& runs, Format format) {
  std::vector<HistorySummary> summaries;
  for (const RunResult& each : runs) summaries.push_back({each.speed, each.summaries});
  Document document;
  document.facts = factsOf(names);
  document.facts.push_back({"speeds", static_cast<long>(runs.size()), ""});
  document.tables = {runTable(runs), speedTable(runs.front().history.columns(), summaries, format)};
  return document;
}

}  // namespace vehicle::report
