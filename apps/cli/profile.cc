#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/run_options.h"
#include "libvehicle/report/profile/profile_tables.h"
#include "libvehicle/report/profile/realtime_tables.h"
#include "libvehicle/report/trace/chrome_trace.h"
#include "libvehicle/report/trace/timeline.h"
#include "libvehicle/simulate/file_warnings.h"
#include "libvehicle/storage/atomic_file.h"

namespace vehicle::cli {
namespace {

struct Options {
  ModelFiles files;
  RunChoice choice;
  int every = 16;
  std::string trace, timeline;   // files, or empty
  std::optional<double> period;  // [s] of --realtime
  Overwrite overwrite = Overwrite::kOwnFiles;
  CommonOptions common;
};

void store(const std::string& file, const std::string& text, const CommonOptions& common) {
  if (file.empty()) return;
  writeAtomically(file, text);
  printWritten({file}, common);
}

/// By the clock one thread makes rk4 steps of one period, and nothing is traced.
void requireUsedByTheClock(const CLI::App& command) {
  const auto refuse = [&](const char* option, const char* why) {
    if (command.count(option) == 0) return;
    throw std::invalid_argument(fmt::format("{} has no effect: with --realtime {}; omit one of them", option, why));
  };
  for (const char* option : {"--threads", "--scheme", "--map", "--waiting"}) {
    refuse(option, "one thread computes all equations");
  }
  refuse("--method", "the method is rk4");
  refuse("--step", "the period is the step");
  for (const char* option : {"--every", "--trace", "--timeline"}) refuse(option, "no step is traced");
}

void requireOptionsUsed(const CLI::App& command, const Options& options, const Model& model) {
  if (options.period) {
    requireSpeedUsed(command, {model.scenario});
    return;
  }
  requireRunOptionsUsed(command, options.choice, model);
  requireThreadsFor(command, {"--waiting", "--pinning", "--priority", "--every"}, options.choice);
}

int profileByTheClock(const Model& model, const Options& options) {
  const double period = options.period.value();
  RealtimeRun run;
  {
    ProgressBar bar(options.common.progress(), durationOf(model.scenario), "s");
    run = simulateRealtime(model.vehicle, model.scenario, options.choice, period,
                           [&](double share) { return bar.update(share, "realtime"); });
  }
  Warnings warnings = fileWarnings(model.vehicle);
  warnings.insert(warnings.end(), run.warnings.begin(), run.warnings.end());
  const report::RunNames names{model.vehicle.vehicle.name, model.scenario.name, run.form, "rk4"};
  printDocument(withSettings(report::documentOf(names, run, period), model.settings), warnings, options.common);
  printWarnings(warnings);
  if (!run.report.stopped) return statusAfter(warnings, options.common);
  std::cerr << fmt::format("vehicle: interrupted after {} of {} steps; the figures above end there\n", run.report.steps,
                           run.steps);
  return kInterrupted;
}

int profileThreads(const Model& model, const Options& options) {
  Profile profile;
  {
    ProgressBar bar(options.common.progress(), 1.0, "profiles");
    profile = profileOf(model.vehicle, model.scenario, options.choice, options.every,
                        [&](double share) { return bar.update(share, "profile"); });
  }
  if (profile.stopped) {
    std::cerr << "vehicle: interrupted; the threads were not watched to the end\n";
    return kInterrupted;
  }
  // The equations, not the motion, are what is profiled: of the run itself nothing is said.
  const Warnings warnings = fileWarnings(model.vehicle);
  const report::RunNames names{model.vehicle.vehicle.name, model.scenario.name, profile.run.form, profile.run.method};
  printDocument(withSettings(report::documentOf(names, profile), model.settings), warnings, options.common);
  printWarnings(warnings);
  const std::string title = report::titleOf(profile, model.vehicle.vehicle.name);
  store(options.trace, report::chromeTraceOf(profile.trace, title), options.common);
  store(options.timeline, report::timelineOf(profile.trace, title), options.common);
  return statusAfter(warnings, options.common);
}

int profileAndPrint(const Options& options, const CLI::App& command) {
  requireOutputForOverwrite(command, {"--trace", "--timeline"});
  if (options.period) requireUsedByTheClock(command);
  const Model model = readModel(options.files);
  requireOneSpeed(command, model.settings);
  OutputGuard guard(options.overwrite);
  protectInputs(guard, model);
  if (command.count("--trace") > 0) guard.claim(options.trace, "--trace", OutputKind::kTrace);
  if (command.count("--timeline") > 0) guard.claim(options.timeline, "--timeline", OutputKind::kTimeline);
  requireOptionsUsed(command, options, model);
  printNotes(notesOn(model.scenario), options.common);
  return options.period ? profileByTheClock(model, options) : profileThreads(model, options);
}

}  // namespace

Action addProfile(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  options->choice.sharing.threads = 4;
  options->choice.method = "rk4";
  CLI::App* command = program.add_subcommand("profile", "show how threads that share a run compute, wait and move");
  addVehicleFile(*command, options->files);
  addScenarioFile(*command, options->files);
  addSharing(*command, options->choice, "4");
  addQuantity(*command, "--realtime", Dimension::kTime,
              "one rk4 step is released every period of true time, on one thread, the rail fed by another; shows "
              "jitter and missed deadlines   (default: off)",
              [options, command](double value) {
                options->period = value;
                if (command->count("--priority") == 0) options->choice.team.priority = Priority::kFifo;
              });
  addTeam(*command, options->choice.team);
  command->add_option("--form", options->choice.form, "flat | matrix   (default: flat where it fits, else matrix)")
      ->type_name("NAME")
      ->check(oneOf(formNames()));
  command->add_option("--method", options->choice.method, "rk4 | rk4_split   (default: rk4)")
      ->type_name("NAME")
      ->check(oneOf(methodNames()));
  addQuantity(*command, "--speed", Dimension::kSpeed, "running speed   (default: from SCENARIO)",
              [options](double value) { options->choice.speed = value; });
  addSet(*command, options->files.settings);
  addQuantity(*command, "--step", Dimension::kTime, "rk4: largest step   (default: \"1 ms\")",
              [options](double value) { options->choice.step = value; });
  addCount(*command, "--every", options->every, "traces every N-th step; 1 traces all   (default: 16)");
  command
      ->add_option("--trace", options->trace,
                   "what each thread did and when, for the viewer ui.perfetto.dev, .json   (default: none)")
      ->type_name("FILE");
  command
      ->add_option("--timeline", options->timeline, "two steps drawn, one line for each thread, .svg   (default: none)")
      ->type_name("FILE");
  addOverwrite(*command, options->overwrite);
  addCommonOptions(*command, options->common);
  command->footer(
      "Runs on one thread, on several, and on several while their steps are recorded (traced), alternately, and prints "
      "the time per step of each.\n"
      "Example: vehicle profile models/vehicles/al-oraiqat-2017.xml models/scenarios/paper-20mps.xml \\\n"
      "             --threads 4 --scheme stages --map paper --timeline threads.svg");
  return [options, command] { return profileAndPrint(*options, *command); };
}

}  // namespace vehicle::cli
