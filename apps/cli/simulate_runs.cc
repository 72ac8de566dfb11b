#include "apps/cli/simulate_runs.h"

#include <algorithm>
#include <iostream>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "apps/cli/exit_status.h"
#include "apps/cli/history_table.h"
#include "apps/cli/progress.h"
#include "apps/cli/remarks.h"
#include "apps/cli/run_files.h"
#include "apps/cli/speeds.h"
#include "apps/cli/stdout_page.h"
#include "apps/cli/thread_options.h"
#include "libvehicle/project/together.h"
#include "libvehicle/simulate/stiffness.h"

namespace vehicle::cli {

namespace {

/// One of several runs.
struct SpeedRun {
  RunChoice choice;
  RunResult result;              // without its history, which is written
  std::vector<Channel> columns;  // of it
  std::vector<std::string> outputs;
};

void requireAll(const SimulateOptions& options, const Model& model) {
  ProblemList problems;
  for (const double speed : options.speeds) problems.append(checkTogether(model.vehicle, model.scenario, speed));
  if (!problems.empty()) throw InvalidInput(std::move(problems));
}

std::vector<SpeedRun> runAll(const SimulateOptions& options, const Model& model) {
  const auto shown = options.common.quiet ? ProgressBar::Shown::kNever : ProgressBar::Shown::kOnTerminal;
  const double count = static_cast<double>(options.speeds.size());
  ProgressBar bar(shown, count, "runs");
  std::vector<SpeedRun> runs;
  for (const double speed : options.speeds) {
    SpeedRun& run = runs.emplace_back();
    run.choice = options.choice;
    run.choice.speed = speed;
    run.outputs = outputsAt(options, speed);
    const double before = static_cast<double>(runs.size() - 1);
    run.result = runAndStore(model, run.choice, run.outputs,
                             [&](double share) { return bar.update((before + share) / count, "simulate"); });
    run.columns = run.result.history.columns();
    run.result.history = TimeHistory();
    if (run.result.statistics.stopped) break;
  }
  return runs;
}

Table runTable(const std::vector<SpeedRun>& runs) {
  Table table{"runs",
              {{"speed", "m/s"},
               {"end of run", "s"},
               {"samples", ""},
               {"steps", ""},
               {"evaluations", ""},
               {"rejected steps", ""},
               {"run time", "s"}},
              {}};
  for (const SpeedRun& each : runs) {
    const RunResult& result = each.result;
    table.rows.push_back({result.speed, result.reached, result.outputs, result.statistics.steps,
                          result.statistics.evaluations, result.statistics.rejected, result.wall_seconds});
  }
  return table;
}

/// Of a vehicle itself once, of a motion with its speed.
Warnings warningsOf(const std::vector<SpeedRun>& runs) {
  Warnings all;
  std::set<std::string> said;
  for (const SpeedRun& run : runs) {
    for (Warning each : run.result.warnings) {
      if (each.time) each.subject = fmt::format("at {}: {}", speedText(run.result.speed), each.subject);
      if (said.insert(each.text()).second) all.push_back(std::move(each));
    }
  }
  return all;
}

void printNotesOf(const std::vector<SpeedRun>& runs, const SimulateOptions& options, const Model& model) {
  std::set<std::string> said;
  const auto say = [&](const std::string& note) {
    if (!note.empty() && said.insert(note).second) printNote(note, options.common);
  };
  for (const SpeedRun& run : runs) {
    for (const std::string& note : run.result.notes) say(note);
    say(stiffnessNote(model.vehicle, model.scenario, run.choice, run.result));
  }
  noteUnshared(options.choice, runs.front().result, options.common);
}

}  // namespace

RunResult runAndStore(const Model& model, RunChoice choice, const std::vector<std::string>& outputs,
                      const Progress& progress) {
  choice.keep = outputs.empty() ? Keep::kNothing : Keep::kOutputs;
  RunResult result = simulate(model.vehicle, model.scenario, choice, progress);
  const RunRecord record = recordOf(model, choice, result);
  for (const std::string& output : outputs) writeHistory(output, record);
  return result;
}

std::vector<std::string> outputsAt(const SimulateOptions& options, double speed) {
  std::vector<std::string> files;
  for (const std::string& each : options.outputs) files.push_back(fileAtSpeed(each, speed));
  return files;
}

int simulateSpeeds(const SimulateOptions& options, const Model& model) {
  requireAll(options, model);
  const std::vector<SpeedRun> runs = runAll(options, model);
  const RunResult& first = runs.front().result;
  std::vector<HistorySummary> summaries;
  for (const SpeedRun& each : runs) summaries.push_back({each.result.speed, each.result.summaries});

  Document document;
  document.facts = {{"vehicle", model.vehicle.vehicle.name, ""},
                    {"scenario", model.scenario.name, ""},
                    {"form", first.form, ""},
                    {"method", first.method, ""},
                    {"speeds", static_cast<long>(runs.size()), ""}};
  addSettings(model.settings, document);
  document.tables = {runTable(runs),
                     speedTable(runs.front().columns, summaries, options.common.format)};
  const Warnings warnings = warningsOf(runs);
  addWarnings(warnings, options.common, document);
  printToStdout(document, options.common.format);
  std::cout.flush();
  printNotesOf(runs, options, model);
  printWarnings(warnings);
  for (const SpeedRun& run : runs) {
    for (const std::string& output : run.outputs) {
      if (!options.common.quiet) std::cerr << fmt::format("written: {}\n", output);
    }
  }
  if (!runs.back().result.statistics.stopped) return statusAfter(warnings, options.common);
  std::cerr << fmt::format("vehicle: interrupted at {} at t = {:.6g} s; {} of {} speeds are finished\n",
                           speedText(runs.back().result.speed), runs.back().result.reached, runs.size() - 1,
                           options.speeds.size());
  return kInterrupted;
}

}  // namespace vehicle::cli
