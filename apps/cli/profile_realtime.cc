#include "apps/cli/profile_realtime.h"

#include <iostream>

#include <fmt/format.h>

#include "apps/cli/exit_status.h"
#include "apps/cli/profile_tables.h"
#include "apps/cli/progress.h"
#include "apps/cli/remarks.h"
#include "apps/cli/stdout_page.h"
#include "libvehicle/simulate/file_warnings.h"

namespace vehicle::cli {

Document documentOf(const RealtimeRun& run, double period) {
  const RealtimeReport& report = run.report;
  Document document;
  document.facts = {{"period", 1e3 * period, "ms"},
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
                    {"priority", report.thread.priority, ""}};
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

int profileByTheClock(const Model& model, const RunChoice& choice, double period, const CommonOptions& common) {
  const auto shown = common.quiet ? ProgressBar::Shown::kNever : ProgressBar::Shown::kOnTerminal;
  RealtimeRun run;
  {
    ProgressBar bar(shown, durationOf(model.scenario), "s");
    run = simulateRealtime(model.vehicle, model.scenario, choice, period,
                           [&](double share) { return bar.update(share, "realtime"); });
  }
  Document document = documentOf(run, period);
  const std::vector<Fact> names = namesOf(model, run.form, "rk4", run.speed);
  document.facts.insert(document.facts.begin(), names.begin(), names.end());
  addSettings(model.settings, document);
  Warnings warnings = fileWarnings(model.vehicle);
  warnings.insert(warnings.end(), run.warnings.begin(), run.warnings.end());
  addWarnings(warnings, common, document);
  printToStdout(document, common.format);
  printWarnings(warnings);
  if (!run.report.stopped) return statusAfter(warnings, common);
  std::cerr << fmt::format("vehicle: interrupted after {} of {} steps; the figures above end there\n", run.report.steps,
                           run.steps);
  return kInterrupted;
}

}  // namespace vehicle::cli
