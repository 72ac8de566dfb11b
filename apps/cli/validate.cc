#include <algorithm>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "apps/cli/commands.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/progress.h"
#include "apps/cli/validation_tables.h"
#include "libvehicle/xml/reader.h"

namespace vehicle::cli {
namespace {

struct Options {
  ModelFiles files;  // the first may be a suite
  ValidationChoice choice;
  CommonOptions common;
  bool details = false;
};

struct Work {
  std::vector<Vehicle> vehicles;
  std::vector<Scenario> scenarios;
  std::vector<ValidationCase> cases;
  ValidationChoice choice;
  bool is_suite = false;
};

/// The files that a suite names; the problems of all of them are told together.
Work readSuiteFiles(const Options& options) {
  const Suite suite = readSuite(options.files.vehicle).orThrow();
  Work work{{}, {}, casesOf(suite), choiceOf(suite, options.choice), true};
  ProblemList problems;
  for (const FileReference& named : suite.vehicles) {
    Outcome<Vehicle> read = readVehicle(resolvePath(options.files.vehicle, named.file));
    problems.append(read.problems);
    if (read.value) work.vehicles.push_back(std::move(*read.value));
  }
  for (const FileReference& named : suite.scenarios) {
    Outcome<Scenario> read = readScenario(resolvePath(options.files.vehicle, named.file));
    problems.append(read.problems);
    if (read.value) work.scenarios.push_back(std::move(*read.value));
  }
  if (!problems.empty()) throw InvalidInput(std::move(problems));
  return work;
}

Work readWork(const Options& options) {
  const FileKind kind = kindOf(options.files.vehicle).orThrow();
  const bool is_suite = kind == FileKind::kSuite;
  if (is_suite && !options.files.scenario.empty()) throw std::invalid_argument("a suite names its scenarios itself; leave out SCENARIO");
  if (!is_suite && options.files.scenario.empty()) throw std::invalid_argument("SCENARIO is missing, or a suite instead of VEHICLE");
  if (is_suite) return readSuiteFiles(options);
  Model model = readModel(options.files);
  return {{std::move(model.vehicle)}, {std::move(model.scenario)}, {{0, 0, options.choice.run.speed}}, options.choice, false};
}

int validateAll(const Options& options) {
  const Work work = readWork(options);
  const auto shown = options.common.quiet ? ProgressBar::Shown::kNever : ProgressBar::Shown::kOnTerminal;
  const double count = static_cast<double>(work.cases.size());
  std::vector<ValidationReport> reports;
  {
    ProgressBar bar(shown, count, "cases");
    for (const ValidationCase& each : work.cases) {
      ValidationChoice choice = work.choice;
      if (!choice.run.speed) choice.run.speed = each.speed;
      const double before = static_cast<double>(reports.size());
      reports.push_back(validate(work.vehicles[each.vehicle], work.scenarios[each.scenario], choice,
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
  if (stopped) std::cerr << fmt::format("vehicle: interrupted; {} of {} cases are finished\n", reports.size(), work.cases.size());
  return status;
}

}  // namespace

Action addValidate(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("validate", "set every form and method against each other and the exact solution");
  command->add_option("vehicle", options->files.vehicle, "vehicle file, or a suite alone")->type_name("VEHICLE|SUITE")->required();
  command->add_option("scenario", options->files.scenario, "scenario file; none with a suite")->type_name("SCENARIO");
  const auto add_names = [&](const char* name, std::vector<std::string>& names, const std::vector<std::string>& all, const char* help) {
    command->add_option(name, names, help)->type_name("NAME")->expected(1)->check(oneOf(all))->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  };
  add_names("--form", options->choice.forms, formNames(),
            "only this form; may be given several times, and names printed variants too\n(default: all but the printed variants)");
  add_names("--method", options->choice.methods, methodNames(), "only this method; may be given several times   (default: all)");
  addRunSettings(*command, options->choice.run);
  command->add_flag("--details", options->details, "table: every quantity of every run and every pair   (csv and json: always)");
  addCommonOptions(*command, options->common);
  command->footer("Each pair of runs has an expected size of disagreement and a reason for it: rounding, integration error,\n"
                  "or true geometry. A pair outside ends the program with exit status 4 and is named on stderr.\n"
                  "Example: vehicle validate models/vehicles/al-oraiqat-2017.xml models/scenarios/paper-20mps.xml");
  return [options] { return validateAll(*options); };
}

}  // namespace vehicle::cli
