#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "apps/cli/commands.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/history_table.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/outputs.h"
#include "apps/cli/progress.h"
#include "apps/cli/remarks.h"
#include "apps/cli/run_options.h"
#include "apps/cli/simulate_runs.h"
#include "apps/cli/speeds.h"
#include "apps/cli/stdout_page.h"
#include "apps/cli/thread_options.h"
#include "libvehicle/simulate/stiffness.h"

namespace vehicle::cli {
namespace {

int simulateOnce(const SimulateOptions& options, const Model& model) {
  const auto shown = options.common.quiet ? ProgressBar::Shown::kNever : ProgressBar::Shown::kOnTerminal;
  RunResult result;
  {
    ProgressBar bar(shown, durationOf(model.scenario), "s");
    result = runAndStore(model, options.choice, options.outputs,
                         [&](double share) { return bar.update(share, "simulate"); });
  }

  Document document;
  document.facts = {{"vehicle", model.vehicle.name, ""},
                    {"scenario", model.scenario.name, ""},
                    {"form", result.form, ""},
                    {"method", result.method, ""},
                    {"speed", result.speed, "m/s"}};
  for (Fact& fact : sharingFacts(result)) document.facts.push_back(std::move(fact));
  document.facts.insert(document.facts.end(), {{"end of run", result.reached, "s"},
                                               {"samples", result.outputs, ""},
                                               {"steps", result.statistics.steps, ""},
                                               {"evaluations", result.statistics.evaluations, ""},
                                               {"rejected steps", result.statistics.rejected, ""},
                                               {"run time", result.wall_seconds, "s"}});
  document.tables = {decisionTable(result.decision),
                     historyTable(result.history.columns(), result.summaries, options.common.format)};
  addWarnings(result.warnings, options.common, document);
  printToStdout(document, options.common.format);
  for (const std::string& note : result.notes) printNote(note, options.common);
  noteUnshared(options.choice, result, options.common);
  if (const std::string note = stiffnessNote(model.vehicle, model.scenario, options.choice, result); !note.empty()) {
    printNote(note, options.common);
  }
  printWarnings(result.warnings);
  for (const std::string& output : options.outputs) {
    if (!options.common.quiet) std::cerr << fmt::format("written: {}\n", output);
  }
  if (!result.statistics.stopped) return statusAfter(result.warnings, options.common);
  std::cerr << fmt::format("vehicle: interrupted at t = {:.6g} s; the columns above{} end there\n", result.reached,
                           options.outputs.empty() ? "" : " and the files written");
  return kInterrupted;
}

int simulateAndStore(SimulateOptions options, const CLI::App& command) {
  requireOutputForOverwrite(command, {"--output"});
  const Model model = readModel(options.files);
  const bool is_one = options.speeds.size() < 2;
  if (options.speeds.size() == 1) options.choice.speed = options.speeds.front();
  OutputGuard guard(options.overwrite);
  protectModel(guard, model);
  std::vector<std::string> outputs = options.outputs;
  if (!is_one) {
    outputs.clear();
    for (const double speed : options.speeds) {
      for (std::string& each : outputsAt(options, speed)) outputs.push_back(std::move(each));
    }
  }
  for (const std::string& output : outputs) guard.claim(output, "--output", OutputKind::kHistory);
  requireRunOptionsUsed(command, options.choice, model);
  printNotes(notesOn(model.scenario), options.common);
  return is_one ? simulateOnce(options, model) : simulateSpeeds(options, model);
}

}  // namespace

Action addSimulate(CLI::App& program) {
  const auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = program.add_subcommand("simulate", "simulate one vehicle over one track");
  addVehicleFile(*command, options->files);
  addScenarioFile(*command, options->files);
  command
      ->add_option("--form", options->choice.form,
                   "equations: flat (carbody and two bogies by hand) | matrix (any vehicle, linear) | mbs (rigid "
                   "bodies with true "
                   "geometry, by Simbody) | mbs-linear, or as the paper prints them: flat-7-printed | "
                   "flat-literal | flat-literal-mb   (default: flat where it fits, else matrix)")
      ->type_name("NAME")
      ->check(oneOf(formNames()));
  command
      ->add_option("--method", options->choice.method,
                   "rk4 (fixed step) | dopri5 (adaptive step) | exact (matrix exponential) | simbody_rkm (adaptive, by "
                   "Simbody), or for a flat vehicle whose front and rear are alike "
                   "rk4_split   "
                   "(default: exact where it fits and there are 64 states or fewer, else dopri5)")
      ->type_name("NAME")
      ->check(oneOf(methodNames()));
  addSpeeds(
      *command,
      "running speed, e.g. \"20 m/s\"; all of a list \"60 km/h, 80 km/h\" or of a range\n\"80:10:160 km/h\", with one "
      "table, and --output run.h5 becoming run-80kmh.h5, ...\n(default: from SCENARIO)",
      options->speeds);
  addRunSettings(*command, options->choice);
  addSharing(*command, options->choice, "1");
  command
      ->add_option("--output", options->outputs,
                   "time histories, .csv or .h5; may be given several times   (default: none)")
      ->type_name("FILE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  addOverwrite(*command, options->overwrite);
  addCommonOptions(*command, options->common);
  command->footer(
      "Prints a summary of every column in the format chosen; whole histories go to --output. Peaks and r.m.s. are of "
      "the motion itself, followed as closely as it asks for, whatever the output step.\n"
      "Threads change the time that a run takes and no bit of its result.\n"
      "Example: vehicle simulate models/vehicles/al-oraiqat-2017.xml models/scenarios/paper-20mps.xml \\\n"
      "             --speed \"60:20:120 km/h\" --output run.h5");
  return [options, command] { return simulateAndStore(*options, *command); };
}

}  // namespace vehicle::cli
