#include "libvehicle/report/profile/realtime_tables.h"

#include <fmt/format.h>

#include "libvehicle/report/profile/profile_tables.h"

namespace vehicle::report {

Document documentOf(const RunNames& names, const RealtimeRun& run, double period) {
  const RealtimeReport& report = run.report;
  Document document;
  document.facts = factsOf(names, run.speed);
  document.facts.insert(document.facts.end(), {{"period", 1e3 * period, "ms"},
                                               {"steps", report.steps, ""},
                                               {"deadline misses", report.deadline_misses, ""},
                                               {"releases skipped", report.skipped_releases, ""},
                                               {"inputs held", report.inputs_held, ""},
                                               {"inputs late", report.inputs_late, ""},
                                               {"states lost", report.outputs_lost, ""},
                                               {"states read", run.states_read, ""},
                                               {"bits of the run without a clock", run.same_bits, ""},
                                               {"worst response", 1e6 * report.response.most, "us"},
                                               {"memory locked", report.memory_locked, ""},
                                               {"priority", report.thread.priority, ""}});
  document.tables = {quantileTable("times of a step", {quantileRow("from release to running (jitter)", report.wake_up),
                                                       quantileRow("the step itself", report.step),
                                                       quantileRow("from release to end", report.response)}),
                     placementTable({.members = {report.thread}, .waiting = {}, .cores = {}}),
                     histogramTable("histogram of the jitter", "steps", report.wake_up)};
  if (!report.memory_note.empty()) document.remarks.push_back(fmt::format("memory: {}", report.memory_note));
  if (!report.thread.priority_note.empty()) {
    document.remarks.push_back(fmt::format("priority: {}", report.thread.priority_note));
  }
  if (!report.thread.pinning_note.empty()) {
    document.remarks.push_back(fmt::format("core: {}", report.thread.pinning_note));
  }
  return document;
}

}  // namespace vehicle::report
