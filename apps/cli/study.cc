#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <CLI/App.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/run_options.h"
#include "libvehicle/project/best_designs.h"
#include "libvehicle/project/study_resume.h"
#include "libvehicle/project/study_work.h"
#include "libvehicle/report/document/shell_word.h"
#include "libvehicle/report/study/study_tables.h"
#include "libvehicle/study/study_warnings.h"
#ifdef VEHICLE_WITH_MPI
#include "libvehicle/distribute/mpi_executor.h"
#endif

namespace vehicle::cli {
namespace {

struct StudyOptions {
  std::string study;     // file, or "show"
  std::string shown;     // database after "show"
  std::string database;  // --output
  std::vector<std::string> settings;  // --set
  bool resume = false;
  Overwrite overwrite = Overwrite::kOwnFiles;
  int jobs = 0;  // 0: every processing unit
  int best = 5;
  std::string best_folder;
  std::string csv;
  CommonOptions common;
};

[[noreturn]] void refuse(const std::string& message) { throw std::invalid_argument(message); }

bool isShown(const StudyOptions& options) { return options.study == "show"; }

void requireForShow(const CLI::App& command, const StudyOptions& options) {
  if (options.shown.empty()) refuse("study show: DATABASE is missing");
  for (const char* option : {"--output", "--resume", "--set", "--jobs"}) {
    if (command.count(option) > 0) refuseWithoutEffect(option, "study show evaluates nothing", "omit it");
  }
  requireOutputForOverwrite(command, {"--export", "--write-best"});
}

/// What shows before any file is read: a file or option that is missing, or has no effect beside the others.
void requireStudyOptions(const CLI::App& command, const StudyOptions& options) {
  if (isShown(options)) return requireForShow(command, options);
  if (!options.shown.empty()) {
    refuse(fmt::format("study: \"{}\" is one file too many; only `study show` takes a second", options.shown));
  }
  if (command.count("--output") == 0) {
    refuse("study: --output is missing, e.g. --output study.sqlite: every design is kept there");
  }
  if (options.resume) requireOutputForOverwrite(command, {"--export", "--write-best"});
}

/// What has no effect on this study: --best without objectives, --write-best without anything to be written.
void requireUsedByStudy(const CLI::App& command, const Study& study) {
  const std::string remedy = "omit it, or add one to the study";
  if (command.count("--best") > 0 && study.objectives.empty()) {
    refuseWithoutEffect(
        "--best", fmt::format("the study \"{}\" has no <objective>, so no design is better than another", study.name),
        remedy);
  }
  if (command.count("--write-best") > 0 && study.objectives.empty() && study.designs.empty()) {
    refuseWithoutEffect("--write-best",
                        fmt::format("the study \"{}\" has neither an <objective> nor a named <design>", study.name),
                        remedy);
  }
}

/// Protects every file that the study was read from, or the database that is shown, and claims every output.
void claimOutputs(OutputGuard& guard, const CLI::App& command, const StudyOptions& options, const StudyWork& work) {
  if (isShown(options)) {
    guard.protectDatabase(options.shown, "the database");
  } else {
    protectInputs(guard, work, options.study);
    if (options.resume) {
      guard.resumeDatabase(options.database, "--output");
    } else {
      guard.claimDatabase(options.database, "--output");
    }
  }
  if (command.count("--export") > 0) guard.claim(options.csv, "--export", OutputKind::kStudyTable);
  if (command.count("--write-best") > 0) {
    guard.claimFolder(options.best_folder, "--write-best", OutputKind::kVehicle,
                      filesOfBest(BestNames(work, static_cast<std::size_t>(options.best)), work));
  }
}

/// The program as databases name it.
constexpr const char* kProgram = "vehicle " VEHICLE_VERSION;

std::unique_ptr<Executor> executorOf(const StudyOptions& options) {
#ifdef VEHICLE_WITH_MPI
  if (isRankOfJob()) return std::make_unique<MpiExecutor>(options.jobs == 0 ? 1 : options.jobs);
#endif
  return std::make_unique<ThreadExecutor>(options.jobs);
}

/// The part of a rank that does not lead. It keeps silent: what is wrong with the files the leader reports.
int help(const StudyOptions& options, Executor& executor) {
  try {
    FileSource disk;
    Settings settings(options.settings);
    const StudyWork work = readStudyWork(options.study, disk, settings).orThrow();
    settings.requireRight();
    const StudyTarget nowhere;
    evaluate(work, nowhere, executor);
    return kDone;
  } catch (const InvalidInput&) {
    return kInputIsWrong;
  } catch (const std::invalid_argument&) {
    return kCommandLineIsWrong;
  }
}

std::string goOnWith(const StudyOptions& options) {
  std::string settings;
  for (const std::string& each : options.settings) settings += " --set " + report::shellWord(each);
  return fmt::format("Go on with:\n  vehicle study {}{} --output {} --resume", report::shellWord(options.study), settings,
                     report::shellWord(options.database));
}

StudyOutcome evaluateAndWatch(const StudyOptions& options, const StudyWork& work, Executor& executor) {
  const StudyTarget target{options.database, options.resume, kProgram, work.texts,
                           options.overwrite == Overwrite::kAnyFile};
  std::unique_ptr<ProgressBar> bar;
  bool begun = !std::filesystem::exists(options.database);  // from then on the file holds what is done
  const StudyWatch watch = [&](const StudyProgress& progress) {
    begun = true;
    // The rate is of what this run evaluates, the share of the whole study.
    const double missing = static_cast<double>(progress.designs - progress.before);
    if (!bar) bar = std::make_unique<ProgressBar>(options.common.progress(), missing, "designs");
    return bar->update(missing > 0.0 ? static_cast<double>(progress.evaluated) / missing : 1.0, "study");
  };
  try {
    return evaluate(work, target, executor, watch);
  } catch (const RunFailed& failed) {
    if (!begun || !std::filesystem::exists(options.database)) throw;
    throw RunFailed(fmt::format("{}. {}", failed.what(), goOnWith(options)));
  }
}

/// A study on stdout, and what has become doubtful of it on stderr.
struct Shown {
  StudySummary summary;
  Warnings warnings;  // of the study and of its results
};

/// Writes the vehicle files that --write-best asks for.
void writeBestFiles(const StudyOptions& options, const StudyWork& work, const StudySummary& summary) {
  const BestNames names(work, static_cast<std::size_t>(options.best));
  std::vector<std::string> written;
  try {
    written = writeBest(options.best_folder, summary, work, names);
  } catch (const std::invalid_argument& wrong) {
    throw std::invalid_argument(fmt::format("--write-best: {}", wrong.what()));
  }
  printWritten(written, options.common);
  if (!written.empty()) return;
  const bool has_objectives = !summary.best.empty();
  printNote(has_objectives ? "--write-best: nothing is written: no design keeps the limits"
                           : "--write-best: nothing is written: the study has neither objectives nor named designs",
            options.common);
}

/// @param warnings  of the study, which are printed already
Shown show(const StudyOptions& options, const std::string& path, const StudyWork& work, report::Document document,
           Warnings warnings) {
  const StudyDatabase database = StudyDatabase::read(path);
  SummaryChoice choice;
  choice.best = static_cast<std::size_t>(options.best);
  StudySummary summary = summarise(database, work.inputs, work.plan, choice);
  const Warnings late = warningsAfter(work.inputs, summary);
  printWarnings(late);
  warnings.insert(warnings.end(), late.begin(), late.end());
  report::append(report::documentOf(summary, work.inputs, options.common.format), document);
  printDocument(std::move(document), warnings, options.common);
  if (!options.csv.empty()) {
    database.writeCsv(options.csv, [&](std::uint64_t design) { return designName(work.inputs, work.plan, design); });
    printWritten({options.csv}, options.common);
  }
  if (!options.best_folder.empty()) writeBestFiles(options, work, summary);
  return {std::move(summary), std::move(warnings)};
}

report::Document headOf(const StudyWork& work, const std::string& database) {
  report::Document document;
  document.facts = {
      {"study", work.inputs.study.name, ""}, {"vehicle", work.inputs.vehicle.name, ""}, {"database", database, ""}};
  return withSettings(std::move(document), work.settings);
}

/// Evaluates what is missing, then shows the whole study. On a rank of an MPI job that does not lead: only evaluates.
int runStudyFile(const StudyOptions& options, const CLI::App& command) {
  const std::unique_ptr<Executor> executor = executorOf(options);
  if (!executor->leads()) return help(options, *executor);
  FileSource disk;
  Settings settings(options.settings);
  const StudyWork work = readStudyWork(options.study, disk, settings).orThrow();
  settings.requireRight();
  if (ProblemList problems = checkBeforeFirstDesign(work, options.study); !problems.empty()) {
    throw InvalidInput(std::move(problems));
  }
  requireUsedByStudy(command, work.inputs.study);
  OutputGuard guard(options.overwrite);
  claimOutputs(guard, command, options, work);
  if (options.resume && std::filesystem::exists(options.database)) {
    requireOwnDatabase(options.database, options.study, work, kProgram);
  }
  report::Document document = headOf(work, options.database);
  document.remarks.push_back(StudyEvaluator(work.inputs).path().text);
  printNotes(notesOn(work.inputs.scenarios), options.common);
  const Warnings doubts = warningsBefore(work.inputs);
  printWarnings(doubts);

  const StudyOutcome outcome = evaluateAndWatch(options, work, *executor);
  const StudyProgress& done = outcome.progress;
  document.facts.insert(document.facts.end(), {{"threads", static_cast<long>(executor->threads()), ""},
                                               {"evaluated now", static_cast<long>(done.evaluated), ""},
                                               {"time", done.seconds, "s"}});
  if (done.evaluated > 0) {
    document.facts.push_back({"rate", static_cast<double>(done.evaluated) / done.seconds, "designs/s"});
  }
  const auto [summary, warnings] = show(options, options.database, work, std::move(document), doubts);
  if (outcome.ending != Ending::kFinished) {
    std::cerr << fmt::format("vehicle: interrupted; {} of {} designs are kept. {}\n", done.before + done.evaluated,
                             done.designs, goOnWith(options));
    return kInterrupted;
  }
  if (summary.failed < summary.designs) return statusAfter(warnings, options.common);
  std::cerr << fmt::format("vehicle: every design of the study failed: {}\n", summary.failures.front().message);
  return kRunFailed;
}

/// Shows what a database holds.
int showStudy(const StudyOptions& options, const CLI::App& command) {
  const StudyRecord record = StudyDatabase::read(options.shown).record();
  const StudyWork work = restoredFrom(record, options.shown);
  requireUsedByStudy(command, work.inputs.study);
  OutputGuard guard(options.overwrite);
  claimOutputs(guard, command, options, work);
  report::Document document = headOf(work, options.shown);
  document.facts.push_back({"written by", record.program, ""});
  const Warnings doubts = warningsBefore(work.inputs);
  printWarnings(doubts);
  const Shown shown = show(options, options.shown, work, std::move(document), doubts);
  return statusAfter(shown.warnings, options.common);
}

}  // namespace

Action addStudy(CLI::App& program) {
  const auto options = std::make_shared<StudyOptions>();
  CLI::App* command =
      program.add_subcommand("study", "compare many designs of a vehicle and store every one in a database");
  command
      ->add_option("study", options->study,
                   "study file, e.g. models/studies/secondary-suspensions.xml; or the word show")
      ->type_name("STUDY|show")
      ->required();
  command->add_option("database", options->shown, "after show: a database that a study has written")
      ->type_name("DATABASE");
  command
      ->add_option("--output", options->database,
                   "database of the designs, .sqlite; one that exists asks for --resume or --overwrite   (required)")
      ->type_name("FILE");
  command->add_flag("--resume", options->resume,
                    "continue the study in --output, if that exists   (default: it is not touched)");
  addSet(*command, options->settings, "; of the vehicle and all scenarios, before the study changes anything");
  addCount(*command, "--jobs", options->jobs, "threads   (default: every processor this program may use)", 1024);
  addCount(*command, "--best", options->best, "designs shown of each objective   (default: 5)", 1000);
  command
      ->add_option("--write-best", options->best_folder,
                   "vehicle files of these designs; without objectives, of the named designs   (default: none)")
      ->type_name("FOLDER");
  command->add_option("--export", options->csv, "the whole table, .csv   (default: none)")->type_name("FILE");
  addOverwrite(*command, options->overwrite, "; an existing study in --output is started anew");
  addCommonOptions(*command, options->common);
  command->footer(
      "Designs are stored as they are evaluated: a study that is killed loses a few seconds and continues "
      "with --resume. "
      "`vehicle study show FILE.sqlite` prints a stored study. On several machines: mpirun -n 4 vehicle study ...\n"
      "Example: vehicle study models/studies/secondary-suspensions.xml --output suspensions.sqlite");
  return [options, command] {
    requireStudyOptions(*command, *options);
    return options->study == "show" ? showStudy(*options, *command) : runStudyFile(*options, *command);
  };
}

}  // namespace vehicle::cli
