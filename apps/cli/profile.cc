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
#include "apps/cli/profile_realtime.h"
#include "apps/cli/profile_run.h"
#include "apps/cli/profile_tables.h"
#include "apps/cli/progress.h"
#include "apps/cli/thread_options.h"
#include "apps/cli/timeline.h"
#include "libvehicle/storage/atomic_file.h"

namespace vehicle::cli {
namespace {

struct Options {
  ModelFiles files;
  RunChoice choice;
  int every = 16;
  std::string trace, timeline;   // files, or empty
  std::optional<double> period;  // [s] of --realtime
  CommonOptions common;
};

void store(const std::string& file, const std::string& text, bool quiet) {
  if (file.empty()) return;
  AtomicFile written(file);
  written.write(text);
  written.publish();
  if (!quiet) std::cerr << fmt::format("written: {}\n", file);
}

/// Opened and given up again before the run: it would be in vain.
void requireWritable(const Options& options) {
  if (!options.trace.empty() && options.trace == options.timeline)
    throw std::invalid_argument("--trace and --timeline name the same file");
  for (const std::string& file : {options.trace, options.timeline}) {
    if (!file.empty()) const AtomicFile probe(file);
  }
}

int profileAndPrint(const Options& options) {
  requireWritable(options);
  const Model model = readModel(options.files);
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
  print(document, options.common.format, std::cout);
  const std::string title = titleOf(profile, model.vehicle.name);
  store(options.trace, chromeTraceOf(profile.trace, title), options.common.quiet);
  store(options.timeline, timelineOf(profile.trace, title), options.common.quiet);
  return kDone;
}

}  // namespace

Action addProfile(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  options->choice.threads = 4;
  options->choice.method = "rk4";
  CLI::App* command = program.add_subcommand("profile", "show how threads that share a run compute, wait and move");
  addVehicleFile(*command, options->files);
  addScenarioFile(*command, options->files);
  addSharing(*command, options->choice, "4");
  CLI::Option* realtime = addQuantity(*command, "--realtime", Dimension::kTime,
                                      "one rk4 step is released every period of true time, on one thread, the\nrail "
                                      "fed by another; tells jitter and missed deadlines   (default: off)",
                                      [options, command](double value) {
                                        options->period = value;
                                        if (command->count("--priority") == 0)
                                          options->choice.team.priority = Priority::kFifo;
                                      });
  addTeam(*command, options->choice.team);
  command->add_option("--form", options->choice.form, "flat | matrix   (default: flat where it fits, else matrix)")
      ->type_name("NAME")
      ->check(oneOf(formNames()));
  command->add_option("--method", options->choice.method, "rk4 | exact | rk4_split | exact_split   (default: rk4)")
      ->type_name("NAME")
      ->check(oneOf(methodNames()));
  addQuantity(*command, "--speed", Dimension::kSpeed, "running speed   (default: from SCENARIO)",
              [options](double value) { options->choice.speed = value; });
  addQuantity(*command, "--step", Dimension::kTime, "rk4: largest step   (default: \"1 ms\")",
              [options](double value) { options->choice.step = value; });
  addCount(*command, "--every", options->every, "traces every N-th step; 1 traces all   (default: 16)");
  command->add_option("--trace", options->trace, "spans as JSON for Perfetto   (default: none)")->type_name("FILE");
  command->add_option("--timeline", options->timeline, "two steps as an SVG   (default: none)")->type_name("FILE");
  for (const char* other :
       {"--threads", "--scheme", "--map", "--waiting", "--method", "--step", "--every", "--trace", "--timeline"}) {
    realtime->excludes(command->get_option(other));
  }
  addCommonOptions(*command, options->common);
  command->footer(
      "Runs serial code, shared and traced in turn and tells the time of a step of each, a loss like a gain.\n"
      "Example: vehicle profile models/vehicles/al-oraiqat-2017.xml models/scenarios/paper-20mps.xml \\\n"
      "             --threads 4 --scheme stages --map paper --timeline threads.svg");
  return [options] { return profileAndPrint(*options); };
}

}  // namespace vehicle::cli
