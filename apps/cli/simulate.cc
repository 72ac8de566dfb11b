#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/run_options.h"
#include "libvehicle/diagnostics/warning_collector.h"
#include "libvehicle/project/run_files.h"
#include "libvehicle/project/speeds.h"
#include "libvehicle/report/run/run_document.h"
#include "libvehicle/simulate/run_notes.h"

namespace vehicle::cli {
namespace {

struct Options {
  ModelFiles files;
  RunChoice choice;
  std::vector<double> speeds;  // [m/s]; empty: the scenario's
  std::vector<std::string> outputs;
  Overwrite overwrite = Overwrite::kOwnFiles;
  CommonOptions common;
};

report::RunNames namesOf(const Model& model, const RunResult& result) {
  return {model.vehicle.vehicle.name, model.scenario.name, result.form, result.method};
}

int simulateOnce(const Options& options, const Model& model) {
  RunResult result;
  {
    ProgressBar bar(options.common.progress(), durationOf(model.scenario), "s");
    result = simulateAndStore(model, options.choice, {options.outputs, VEHICLE_VERSION},
                              [&](double share) { return bar.update(share, "simulate"); });
  }
  const report::Document document = report::documentOf(namesOf(model, result), result, options.common.format);
  printDocument(withSettings(document, model.settings), result.warnings, options.common);
  for (const std::string& note : notesOn(model.vehicle, model.scenario, options.choice, result)) {
    printNote(note, options.common);
  }
  printWarnings(result.warnings);
  printWritten(options.outputs, options.common);
  if (!result.statistics.stopped) return statusAfter(result.warnings, options.common);
  std::cerr << fmt::format("vehicle: interrupted at t = {:.6g} s; the columns above{} end there\n", result.reached,
                           options.outputs.empty() ? "" : " and the files written");
  return kInterrupted;
}

int simulateAtSpeeds(const Options& options, const Model& model) {
  std::vector<RunResult> runs;
  {
    ProgressBar bar(options.common.progress(), static_cast<double>(options.speeds.size()), "runs");
    runs = simulateSpeeds(model, options.choice, options.speeds, {options.outputs, VEHICLE_VERSION},
                          [&](double share) { return bar.update(share, "simulate"); });
  }
  WarningCollector collector;
  for (const RunResult& each : runs) collector.add(each.warnings, "at " + speedText(each.speed));
  const Warnings warnings = collector.take();
  const report::Document document = report::documentOf(namesOf(model, runs.front()), runs, options.common.format);
  printDocument(withSettings(document, model.settings), warnings, options.common);
  for (const std::string& note : notesOn(model.vehicle, model.scenario, options.choice, runs)) {
    printNote(note, options.common);
  }
  printWarnings(warnings);
  for (const RunResult& each : runs) printWritten(filesAtSpeed(options.outputs, each.speed), options.common);
  const RunResult& last = runs.back();
  if (!last.statistics.stopped) return statusAfter(warnings, options.common);
  std::cerr << fmt::format("vehicle: interrupted at {} at t = {:.6g} s; {} of {} speeds are finished\n",
                           speedText(last.speed), last.reached, runs.size() - 1, options.speeds.size());
  return kInterrupted;
}

int simulateAndPrint(Options options, const CLI::App& command) {
  requireOutputForOverwrite(command, {"--output"});
  const Model model = readModel(options.files);
  requireOneSpeed(command, model.settings);
  const bool is_one = options.speeds.size() < 2;
  if (options.speeds.size() == 1) options.choice.speed = options.speeds.front();
  OutputGuard guard(options.overwrite);
  protectInputs(guard, model);
  std::vector<std::string> outputs;
  if (is_one) outputs = options.outputs;
  for (const double speed : is_one ? std::vector<double>{} : options.speeds) {
    for (std::string& each : filesAtSpeed(options.outputs, speed)) outputs.push_back(std::move(each));
  }
  for (const std::string& output : outputs) guard.claim(output, "--output", OutputKind::kHistory);
  requireRunOptionsUsed(command, options.choice, model);
  printNotes(notesOn(model.scenario), options.common);
  return is_one ? simulateOnce(options, model) : simulateAtSpeeds(options, model);
}

}  // namespace

Action addSimulate(CLI::App& program) {
  const auto options = std::make_shared<Options>();
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
      ->add_option(
          "--method", options->choice.method,
          methodSummaries() + "   (default: exact where it fits and there are 64 states or fewer, else dopri5)")
      ->type_name("NAME")
      ->check(oneOf(methodNames()));
  addSpeeds(
      *command,
      "running speed, e.g. \"20 m/s\"; all of a list \"60 km/h, 80 km/h\" or of a range\n\"80:10:160 km/h\", with one "
      "table, and --output run.h5 becoming run-80kmh.h5, ...\n(default: from SCENARIO)",
      options->speeds);
  addSet(*command, options->files.settings);
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
  return [options, command] { return simulateAndPrint(*options, *command); };
}

}  // namespace vehicle::cli
