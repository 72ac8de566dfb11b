#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "apps/cli/chrome_trace.h"
#include "apps/cli/commands.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/outputs.h"
#include "apps/cli/profile_realtime.h"
#include "apps/cli/profile_run.h"
#include "apps/cli/profile_tables.h"
#include "apps/cli/progress.h"
#include "apps/cli/remarks.h"
#include "apps/cli/run_options.h"
#include "apps/cli/stdout_page.h"
#include "apps/cli/thread_options.h"
#include "apps/cli/timeline.h"
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

void store(const std::string& file, const std::string& text, bool quiet) {
  if (file.empty()) return;
  AtomicFile written(file);
  written.write(text);
  written.publish();
  if (!quiet) std::cerr << fmt::format("written: {}\n", file);
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

int profileAndPrint(const Options& options, const CLI::App& command) {
  requireOutputForOverwrite(command, {"--trace", "--timeline"});
  if (options.period) requireUsedByTheClock(command);
  const Model model = readModel(options.files);
  OutputGuard guard(options.overwrite);
  protectModel(guard, model);
  if (command.count("--trace") > 0) guard.claim(options.trace, "--trace", OutputKind::kTrace);
  if (command.count("--timeline") > 0) guard.claim(options.timeline, "--timeline", OutputKind::kTimeline);
  requireOptionsUsed(command, options, model);
  printNotesOn({model.scenario}, options.common);
  if (options.period) return profileByTheClock(model, options.choice, *options.period, options.common);
  Profile profile;
  {
    const auto shown = options.common.quiet ? ProgressBar::Shown::kNever : ProgressBar::Shown::kOnTerminal;
    ProgressBar bar(shown, 1.0, "profiles");
    const auto ask = [&](double share) { return bar.update(share, "profile"); };
    profile = profileOf(model, options.choice, options.every, ask);
  }
  if (profile.stopped) {
    std::cerr << "vehicle: interrupted; the threads were not watched to the end\n";
    return kInterrupted;
  }
  Document document = documentOf(profile);
  const std::vector<Fact> names = namesOf(model, profile.run.form, profile.run.method, profile.run.speed);
  document.facts.insert(document.facts.begin(), names.begin(), names.end());
  // The equations, not the motion, are what is profiled: of the run itself nothing is said.
  const Warnings warnings = fileWarnings(model.vehicle, model.scenario.gravity);
  addWarnings(warnings, options.common, document);
  printToStdout(document, options.common.format);
  printWarnings(warnings);
  const std::string title = titleOf(profile, model.vehicle.name);
  store(options.trace, chromeTraceOf(profile.trace, title), options.common.quiet);
  store(options.timeline, timelineOf(profile.trace, title), options.common.quiet);
  return statusAfter(warnings, options.common);
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
