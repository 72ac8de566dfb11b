#include <algorithm>
#include <cstddef>
#include <iostream>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/run_options.h"
#include "libvehicle/project/validation_work.h"
#include "libvehicle/report/validation/validation_tables.h"
#include "libvehicle/validation/overall.h"

namespace vehicle::cli {
namespace {

struct Options {
  ModelFiles files;  // the first may be a suite
  ValidationChoice choice;
  CommonOptions common;
  bool details = false;
  bool allow_unjudged = false;
};

void requireOnce(const char* option, const std::vector<std::string>& names) {
  std::set<std::string> seen;
  for (const std::string& each : names) {
    if (!seen.insert(each).second) throw std::invalid_argument(fmt::format("{} {} is given twice", option, each));
  }
}

bool isAnyGiven(const CLI::App& command, const std::vector<std::string>& options) {
  return std::any_of(options.begin(), options.end(),
                     [&](const std::string& option) { return command.count(option) > 0; });
}

void requireSharedRunsFor(const CLI::App& command, const ValidationWork& work, bool shares) {
  const bool serial = command.count("--serial") > 0;
  const std::string none = "none of these runs is shared among threads, as only some of the form flat are";
  if (serial && !shares) refuseWithoutEffect("--serial", none, "omit it");
  if (shares && !serial) return;
  const std::string why = serial ? "--serial omits the runs that threads share" : none;
  if (command.count("--time-limit") > 0) refuseWithoutEffect("--time-limit", why, "omit it");
  // A suite may have cases of which nothing can be judged for other reasons.
  if (command.count("--allow-unjudged") > 0 && !work.hasSeveral())
    refuseWithoutEffect("--allow-unjudged", why, "omit it");
}

/// Options of `validate` that would have no effect beside the others and the files given are refused: settings that no
/// method reads, --speed on rigs, what is about shared runs where none is, --details where all is printed or nothing
/// more is; and a form or method that is named twice.
/// @throws std::invalid_argument  with the reason and what to do
void requireOptionsUsed(const CLI::App& command, const ValidationWork& work, const Options& options) {
  requireOnce("--form", options.choice.forms);
  requireOnce("--method", options.choice.methods);
  requireSpeedUsed(command, work.cases.scenarios);
  if (command.count("--details") > 0 && work.hasSeveral()) {
    refuseWithoutEffect("--details",
                        work.is_suite ? "a suite prints one line for each case" : "several speeds print one line each",
                        work.is_suite ? "omit it, or validate one vehicle and scenario" : "omit it, or give one speed");
  }
  if (command.count("--details") > 0 && options.common.format != report::Format::kTable) {
    refuseWithoutEffect("--details", "csv and json hold every detail always", "omit it");
  }
  // The plan asks for eigenvalues of every vehicle: only where something depends on it.
  if (!isAnyGiven(command,
                  {"--step", "--rtol", "--atol", "--accuracy", "--serial", "--time-limit", "--allow-unjudged"})) {
    return;
  }
  const PlannedRuns planned = plannedRuns(work.cases);
  std::string names;
  for (const std::string& each : planned.methods) names += (names.empty() ? "" : ", ") + each;
  requireSettingsUsed(command, {planned.methods.begin(), planned.methods.end()},
                      "the methods that run here are " + names);
  requireSharedRunsFor(command, work, planned.shares);
}

ExitStatus statusOf(Overall overall) {
  constexpr ExitStatus kStatus[] = {kDone, kCheckDidNotHold, kRunFailed, kInterrupted};  // (overalls)
  return kStatus[static_cast<std::size_t>(overall)];
}

report::Document documentOf(const std::vector<ValidationReport>& reports, bool has_several, const Options& options) {
  if (has_several) return report::documentOf(reports);
  const bool all = options.details || options.common.format != report::Format::kTable;
  return report::documentOf(reports.front(), all ? report::Detail::kAll : report::Detail::kSummary);
}

int validateAll(const Options& options, const CLI::App& command) {
  FileSource disk;
  const std::vector<Setting> settings = Settings(options.files.settings).all();
  requireOneSpeed(command, settings);
  const ValidationWork work = readValidationWork({options.files.vehicle, options.files.scenario, options.files.settings},
                                                 options.choice, disk);
  requireOptionsUsed(command, work, options);
  printNotes(notesOn(work.cases.scenarios), options.common);
  Warnings warnings;
  if (work.is_suite) warnings = unjudgedOf(work.cases);
  printWarnings(warnings);
  std::vector<ValidationReport> reports;
  {
    ProgressBar bar(options.common.progress(), static_cast<double>(work.cases.cases.size()), "cases");
    reports = validateCases(work.cases, [&](double share, const std::string& what) { return bar.update(share, what); });
  }
  const Warnings found = warningsOf(reports, work.hasSeveral());
  warnings.insert(warnings.end(), found.begin(), found.end());
  // A case that was interrupted has nothing to show but that.
  if (work.hasSeveral() || !reports.front().stopped) {
    printDocument(withSettings(documentOf(reports, work.hasSeveral(), options), settings), warnings, options.common);
  }
  printWarnings(found);
  for (const ValidationReport& each : reports) {
    for (const std::string& complaint : report::complaintsOf(each)) std::cerr << "vehicle: " << complaint << '\n';
  }
  const ExitStatus status = statusOf(overallOf(reports, options.allow_unjudged ? Unjudged::kAccept : Unjudged::kFail));
  if (reports.back().stopped) {
    std::cerr << fmt::format("vehicle: interrupted; {} of {} cases are finished\n", reports.size() - 1,
                             work.cases.cases.size());
    return status;
  }
  // Of a suite the warnings have said it.
  if (const std::string why = report::whyNothing(reports.front()); !work.hasSeveral() && !why.empty()) {
    std::cerr << "vehicle: " << why << '\n';
  }
  const bool left_out = std::any_of(reports.begin(), reports.end(),
                                    [](const ValidationReport& each) { return each.count(Verdict::kNotJudged) > 0; });
  if (left_out && !options.allow_unjudged) {
    std::cerr << "vehicle: pairs that are not judged are no pass; repeat it on a quieter machine, give a longer "
                 "--time-limit, or accept them with --allow-unjudged\n";
  }
  return status == kDone ? statusAfter(warnings, options.common) : status;
}

}  // namespace

Action addValidate(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("validate", "compare all forms and methods with each other and with the exact solution");
  command->add_option("vehicle", options->files.vehicle, "vehicle file, or a suite alone")
      ->type_name("VEHICLE|SUITE")
      ->required();
  command->add_option("scenario", options->files.scenario, "scenario file; none with a suite")->type_name("SCENARIO");
  const auto add_names = [&](const char* name, std::vector<std::string>& names, const std::vector<std::string>& all,
                             const char* help) {
    command->add_option(name, names, help)
        ->type_name("NAME")
        ->expected(1)
        ->check(oneOf(all))
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  };
  add_names(
      "--form", options->choice.forms, formNames(),
      "only this form; may be given several times, and names variants as the paper prints them too   (default: all "
      "but those)");
  add_names("--method", options->choice.methods, methodNames(),
            "only this method; may be given several times   (default: all)");
  addSpeeds(
      *command,
      "running speed, e.g. \"20 m/s\"; all of a list \"60 km/h, 80 km/h\" or of a range\n\"80:10:160 km/h\", a case "
      "each   (default: from SCENARIO or SUITE)",
      options->choice.speeds);
  addSet(*command, options->files.settings, "; of a suite in every vehicle and scenario that has the name");
  addRunSettings(*command, options->choice.run);
  command->add_flag_callback("--serial", [options] { options->choice.shared.clear(); },
                             "omit the runs that threads share   (default: those of the form flat run too)");
  command->add_flag("--details", options->details,
                    "table: every quantity of every run and every pair   (csv and json: always)");
  options->choice.shared_time_limit = 1.0;
  addQuantity(*command, "--time-limit", Dimension::kTime,
              "that each run shared among threads may take, and again for every 10 000 steps; then it is not judged   "
              "(default: \"1 s\")",
              [options](double value) { options->choice.shared_time_limit = value; });
  command->add_flag("--allow-unjudged", options->allow_unjudged,
                    "pass although pairs were not judged, as long as some were   (default: exit status 4)");
  addCommonOptions(*command, options->common);
  command->footer(
      "Each pair of runs has an expected size of disagreement and a reason for it: rounding, integration error, "
      "or true geometry. A pair outside ends the program with exit status 4 and is named on stderr; so does "
      "a pair that could not be judged.\n"
      "Example: vehicle validate models/vehicles/al-oraiqat-2017.xml models/scenarios/paper-20mps.xml");
  return [options, command] { return validateAll(*options, *command); };
}

}  // namespace vehicle::cli
