#include "apps/cli/study_work.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include "apps/cli/exit_status.h"
#include "apps/cli/model_options.h"
#include "apps/cli/progress.h"
#include "apps/cli/remarks.h"
#include "apps/cli/stdout_page.h"
#include "apps/cli/study_best.h"
#include "apps/cli/study_options.h"
#include "apps/cli/study_resume.h"
#include "apps/cli/study_tables.h"
#include "libvehicle/project/study_work.h"
#include "libvehicle/study/runner.h"
#include "libvehicle/study/search/search_study.h"
#include "libvehicle/study/study_warnings.h"
#ifdef VEHICLE_WITH_MPI
#include "libvehicle/distribute/mpi_executor.h"
#endif

namespace vehicle::cli {
namespace {

std::unique_ptr<Executor> executorOf(const StudyOptions& options) {
#ifdef VEHICLE_WITH_MPI
  if (isRankOfJob()) return std::make_unique<MpiExecutor>(options.jobs == 0 ? 1 : options.jobs);
#endif
  return std::make_unique<ThreadExecutor>(options.jobs);
}

/// The part of a rank that does not lead. It keeps silent: what is wrong with the files the leader tells.
int help(const StudyOptions& options, Executor& executor) {
  try {
    FileSource disk;
    Settings settings(options.settings);
    const StudyWork work = readStudyWork(options.study, disk, settings).orThrow();
    settings.requireRight();
    const StudyTarget nowhere;
    static_cast<void>(work.inputs.study.search ? searchStudy(work.inputs, work.plan, nowhere, executor)
                                               : runStudy(work.inputs, work.plan, nowhere, executor));
    return kDone;
  } catch (const InvalidInput&) {
    return kInputIsWrong;
  } catch (const std::invalid_argument&) {
    return kCommandLineIsWrong;
  }
}

/// A word as a shell takes it.
std::string quoted(const std::string& word) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char letter : word) text += letter == '\'' ? "'\\''" : std::string(1, letter);
  return text + "'";
}

std::string goOnWith(const StudyOptions& options) {
  std::string settings;
  for (const std::string& each : options.settings) settings += " --set " + quoted(each);
  return fmt::format("Go on with:\n  vehicle study {}{} --output {} --resume", quoted(options.study), settings,
                     quoted(options.database));
}

StudyOutcome evaluate(const StudyOptions& options, const StudyWork& work, Executor& executor) {
  const StudyTarget target{options.database, options.resume, kProgram, work.texts,
                           options.overwrite == Overwrite::kAnyFile};
  const auto shown = options.common.quiet ? ProgressBar::Shown::kNever : ProgressBar::Shown::kOnTerminal;
  std::unique_ptr<ProgressBar> bar;
  bool begun = !std::filesystem::exists(options.database);  // from then on the file holds what is done
  const StudyWatch watch = [&](const StudyProgress& progress) {
    begun = true;
    // The rate is of what this run evaluates, the share of the whole study.
    const double missing = static_cast<double>(progress.designs - progress.before);
    if (!bar) bar = std::make_unique<ProgressBar>(shown, missing, "designs");
    return bar->update(missing > 0.0 ? static_cast<double>(progress.evaluated) / missing : 1.0, "study");
  };
  try {
    return work.inputs.study.search ? searchStudy(work.inputs, work.plan, target, executor, watch)
                                    : runStudy(work.inputs, work.plan, target, executor, watch);
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

/// @param warnings  of the study, which are printed already
Shown show(const StudyOptions& options, const std::string& path, const StudyWork& work, Document document,
           Warnings warnings) {
  const StudyDatabase database = StudyDatabase::read(path);
  SummaryChoice choice;
  choice.best = static_cast<std::size_t>(options.best);
  const StudySummary summary = summarise(database, work.inputs, work.plan, choice);
  const Warnings late = warningsAfter(work.inputs, summary);
  printWarnings(late);
  warnings.insert(warnings.end(), late.begin(), late.end());
  document.facts.insert(document.facts.end(), {{"designs", static_cast<long>(summary.designs), ""},
                                               {"evaluated", static_cast<long>(summary.stored), ""},
                                               {"failed", static_cast<long>(summary.failed), ""}});
  if (!work.inputs.bound.limits.empty()) {
    document.facts.push_back({"within limits", static_cast<long>(summary.within_limits), ""});
  }
  if (summary.incomplete > 0) {
    document.facts.push_back({"with values missing", static_cast<long>(summary.incomplete), ""});
  }
  if (summary.warned > 0) document.facts.push_back({"with warnings", static_cast<long>(summary.warned), ""});
  Document told = documentOf(summary, work.inputs, options.common.format);
  document.tables = std::move(told.tables);
  document.remarks.insert(document.remarks.end(), told.remarks.begin(), told.remarks.end());
  addWarnings(warnings, options.common, document);
  printToStdout(document, options.common.format);
  std::cout.flush();
  const auto remark = [&](const std::string& text) {
    if (!options.common.quiet) std::cerr << text << '\n';
  };
  if (!options.csv.empty()) {
    database.writeCsv(options.csv, [&](std::uint64_t design) { return designName(work.inputs, work.plan, design); });
    remark("written: " + options.csv);
  }
  if (options.best_folder.empty()) return {summary, std::move(warnings)};
  const std::vector<std::string> written =
      writeBest(options.best_folder, summary, work, BestNames(work, static_cast<std::size_t>(options.best)));
  for (const std::string& each : written) remark("written: " + each);
  if (written.empty()) {
    printNote(summary.best.empty() ? "--write-best: nothing is written: the study has neither objectives nor named designs"
                                   : "--write-best: nothing is written: no design keeps the limits",
              options.common);
  }
  return {summary, std::move(warnings)};
}

Document headOf(const StudyWork& work, const std::string& database) {
  Document document;
  document.facts = {{"study", work.inputs.study.name, ""},
                    {"vehicle", work.inputs.vehicle.name, ""},
                    {"database", database, ""}};
  addSettings(work.settings, document);
  return document;
}

}  // namespace

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
    requireOwnDatabase(options.database, options.study, work);
  }
  Document document = headOf(work, options.database);
  document.remarks.push_back(StudyEvaluator(work.inputs).path().text);
  printNotesOn(work.inputs.scenarios, options.common);
  const Warnings doubts = warningsBefore(work.inputs);
  printWarnings(doubts);

  const StudyOutcome outcome = evaluate(options, work, *executor);
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

int showStudy(const StudyOptions& options, const CLI::App& command) {
  const StudyRecord record = StudyDatabase::read(options.shown).record();
  const StudyWork work = restoredFrom(record, options.shown);
  requireUsedByStudy(command, work.inputs.study);
  OutputGuard guard(options.overwrite);
  claimOutputs(guard, command, options, work);
  Document document = headOf(work, options.shown);
  document.facts.push_back({"written by", record.program, ""});
  const Warnings doubts = warningsBefore(work.inputs);
  printWarnings(doubts);
  const Shown shown = show(options, options.shown, work, std::move(document), doubts);
  return statusAfter(shown.warnings, options.common);
}

}  // namespace vehicle::cli
