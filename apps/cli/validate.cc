#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/progress.h"
#include "apps/cli/remarks.h"
#include "apps/cli/speeds.h"
#include "apps/cli/stdout_page.h"
#include "apps/cli/validation_options.h"
#include "apps/cli/validation_tables.h"
#include "libvehicle/project/suite_work.h"
#include "libvehicle/xml/reader.h"

namespace vehicle::cli {
namespace {

struct Options {
  ModelFiles files;  // the first may be a suite
  ValidationChoice choice;
  CommonOptions common;
  bool details = false;
  bool allow_unjudged = false;
};

/// VEHICLE and SCENARIO, or a suite alone and all files that it names.
ValidationWork readWork(const ModelFiles& named, const ValidationChoice& choice) {
  FileSource disk;
  Settings settings(named.settings);
  const bool is_suite = kindOf(named.vehicle, disk).orThrow() == FileKind::kSuite;
  if (is_suite && !named.scenario.empty())
    throw std::invalid_argument("a suite names its scenarios itself; omit SCENARIO");
  if (!is_suite && named.scenario.empty())
    throw std::invalid_argument("SCENARIO is missing, or a suite instead of VEHICLE");
  if (is_suite) {
    SuiteWork work = readSuiteWork(named.vehicle, choice, disk, settings).orThrow();
    settings.requireRight();
    return {std::move(work), true};
  }
  Model model = vehicle::readModel(named.vehicle, named.scenario, disk, settings);
  std::vector<ValidationCase> cases;
  for (const double speed : choice.speeds) cases.push_back({0, 0, speed});
  if (cases.empty()) cases.push_back({0, 0, std::nullopt});
  return {{{}, {std::move(model.vehicle.vehicle)}, {std::move(model.scenario)}, std::move(cases), choice}, false};
}

std::vector<ValidationReport> runCases(const SuiteWork& work, const CommonOptions& common) {
  const auto shown = common.quiet ? ProgressBar::Shown::kNever : ProgressBar::Shown::kOnTerminal;
  const double count = static_cast<double>(work.cases.size());
  ProgressBar bar(shown, count, "cases");
  std::vector<ValidationReport> reports;
  for (const ValidationCase& each : work.cases) {
    ValidationChoice choice = work.choice;
    choice.run.speed = each.speed;
    const double before = static_cast<double>(reports.size());
    reports.push_back(
        validate(modelOf(work, each), work.scenarios[each.scenario], choice,
                 [&](double share, const std::string& what) { return bar.update((before + share) / count, what); }));
    if (reports.back().stopped) break;
  }
  return reports;
}

/// What runs of all cases warned of; of a vehicle itself once, of its motion with the case.
Warnings warningsOf(const std::vector<ValidationReport>& reports, bool has_several) {
  Warnings all;
  std::set<std::string> said;
  for (const ValidationReport& report : reports) {
    for (Warning each : report.warnings) {
      if (has_several && each.time) {
        each.subject = fmt::format("{} on {} at {:.4g} km/h: {}", report.vehicle, report.scenario, 3.6 * report.speed,
                                   each.subject);
      }
      if (said.insert(each.text()).second) all.push_back(std::move(each));
    }
  }
  return all;
}

/// @param warnings  all; of them `found` is yet to be printed
void printReports(const std::vector<ValidationReport>& reports, bool has_several, const Warnings& warnings,
                  const Warnings& found, const Options& options) {
  const bool all = options.details || options.common.format != Format::kTable;
  Document document =
      has_several ? documentOf(reports) : documentOf(reports.front(), all ? Detail::kAll : Detail::kSummary);
  addSettings(Settings(options.files.settings).all(), document);
  addWarnings(warnings, options.common, document);
  // A case that was interrupted has nothing to show but that.
  if (has_several || !reports.front().stopped) printToStdout(document, options.common.format);
  std::cout.flush();
  printWarnings(found);
  for (const ValidationReport& report : reports) {
    for (const std::string& complaint : complaintsOf(report)) std::cerr << "vehicle: " << complaint << '\n';
  }
}

int validateAll(const Options& options, const CLI::App& command) {
  requireOneSpeed(command, Settings(options.files.settings).all());
  const ValidationWork work = readWork(options.files, options.choice);
  requireValidationOptionsUsed(command, work, options.choice, options.common);
  printNotesOn(work.cases.scenarios, options.common);
  Warnings warnings;
  if (work.is_suite) warnings = unjudgedOf(work.cases);
  printWarnings(warnings);
  const std::vector<ValidationReport> reports = runCases(work.cases, options.common);
  const Warnings found = warningsOf(reports, work.hasSeveral());
  warnings.insert(warnings.end(), found.begin(), found.end());
  printReports(reports, work.hasSeveral(), warnings, found, options);
  const ExitStatus status = exitStatusOf(reports, options.allow_unjudged ? Unjudged::kAccept : Unjudged::kFail);
  if (reports.back().stopped) {
    std::cerr << fmt::format("vehicle: interrupted; {} of {} cases are finished\n", reports.size() - 1,
                             work.cases.cases.size());
    return status;
  }
  // Of a suite the warnings have said it.
  if (const std::string why = whyNothing(reports.front()); !work.hasSeveral() && !why.empty()) {
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
