#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "apps/cli/commands.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/progress.h"
#include "apps/cli/validation_tables.h"
#include "apps/cli/validation_work.h"

namespace vehicle::cli {
namespace {

struct Options {
  ModelFiles files;  // the first may be a suite
  ValidationChoice choice;
  CommonOptions common;
  bool details = false;
};

int validateAll(const Options& options) {
  const ValidationWork work = readWork(options.files, options.choice);
  const auto shown = options.common.quiet ? ProgressBar::Shown::kNever : ProgressBar::Shown::kOnTerminal;
  const double count = static_cast<double>(work.cases.size());
  std::vector<ValidationReport> reports;
  {
    ProgressBar bar(shown, count, "cases");
    for (const ValidationCase& each : work.cases) {
      ValidationChoice choice = work.choice;
      if (!choice.run.speed) choice.run.speed = each.speed;
      const double before = static_cast<double>(reports.size());
      reports.push_back(
          validate(work.vehicles[each.vehicle], work.scenarios[each.scenario], choice,
                   [&](double share, const std::string& what) { return bar.update((before + share) / count, what); }));
      if (reports.back().stopped) break;
    }
  }
  const ExitStatus status = exitStatusOf(reports);
  const bool stopped = reports.back().stopped;
  // A case that was broken off was not judged.
  if (stopped) reports.pop_back();
  if (work.is_suite) print(documentOf(reports), options.common.format, std::cout);
  if (!work.is_suite && !stopped) {
    const bool all = options.details || options.common.format != Format::kTable;
    print(documentOf(reports.front(), all ? Detail::kAll : Detail::kSummary), options.common.format, std::cout);
  }
  for (const ValidationReport& report : reports) {
    for (const std::string& complaint : complaintsOf(report)) std::cerr << "vehicle: " << complaint << '\n';
  }
  if (stopped)
    std::cerr << fmt::format("vehicle: interrupted; {} of {} cases are finished\n", reports.size(), work.cases.size());
  return status;
}

}  // namespace

Action addValidate(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("validate", "set every form and method against each other and the exact solution");
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
  add_names("--form", options->choice.forms, formNames(),
            "only this form; may be given several times, and names printed variants too\n(default: all but the printed "
            "variants)");
  add_names("--method", options->choice.methods, methodNames(),
            "only this method; may be given several times   (default: all)");
  addRunSettings(*command, options->choice.run);
  command->add_flag_callback("--serial", [options] { options->choice.shared.clear(); },
                             "no runs shared among threads   (default: the flat form's beside their serial runs)");
  command->add_flag("--details", options->details,
                    "table: every quantity of every run and every pair   (csv and json: always)");
  addCommonOptions(*command, options->common);
  command->footer(
      "Each pair of runs has an expected size of disagreement and a reason for it: rounding, integration error,\n"
      "or true geometry. A pair outside ends the program with exit status 4 and is named on stderr.\n"
      "Example: vehicle validate models/vehicles/al-oraiqat-2017.xml models/scenarios/paper-20mps.xml");
  return [options] { return validateAll(*options); };
}

}  // namespace vehicle::cli
