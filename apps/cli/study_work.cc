#include "apps/cli/study_work.h"

#include <iostream>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "apps/cli/exit_status.h"
#include "apps/cli/progress.h"
#include "apps/cli/study_best.h"
#include "apps/cli/study_files.h"
#include "apps/cli/study_tables.h"
#include "libvehicle/study/runner.h"
#include "libvehicle/study/search/search_study.h"
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
    const StudyWork work = readStudyWork(options.study);
    const StudyTarget nowhere;
    static_cast<void>(work.inputs.study.search ? searchStudy(work.inputs, work.plan, nowhere, executor)
                                               : runStudy(work.inputs, work.plan, nowhere, executor));
    return kDone;
  } catch (const InvalidInput&) {
    return kInputIsWrong;
  }
}

StudyOutcome evaluate(const StudyOptions& options, const StudyWork& work, Executor& executor) {
  const StudyTarget target{options.database, options.resume, "vehicle " VEHICLE_VERSION, work.texts};
  const auto shown = options.common.quiet ? ProgressBar::Shown::kNever : ProgressBar::Shown::kOnTerminal;
  std::unique_ptr<ProgressBar> bar;
  const StudyWatch watch = [&](const StudyProgress& progress) {
    // The rate is of what this run evaluates, the share of the whole study.
    const double missing = static_cast<double>(progress.designs - progress.before);
    if (!bar) bar = std::make_unique<ProgressBar>(shown, missing, "designs");
    return bar->update(missing > 0.0 ? static_cast<double>(progress.evaluated) / missing : 1.0, "study");
  };
  try {
    return work.inputs.study.search ? searchStudy(work.inputs, work.plan, target, executor, watch)
                                    : runStudy(work.inputs, work.plan, target, executor, watch);
  } catch (const InvalidInput& wrong) {
    throw InvalidInput(asSeenFromHere(wrong.problems(), options.study));
  }
}

void show(const StudyOptions& options, const std::string& path, const StudyWork& work, Document document) {
  const StudyDatabase database = StudyDatabase::read(path);
  SummaryChoice choice;
  choice.best = static_cast<std::size_t>(options.best);
  const StudySummary summary = summarise(database, work.inputs, work.plan, choice);
  document.facts.insert(document.facts.end(), {{"designs", static_cast<long>(summary.designs), ""},
                                               {"evaluated", static_cast<long>(summary.stored), ""},
                                               {"failed", static_cast<long>(summary.failed), ""}});
  if (!work.inputs.bound.limits.empty()) {
    document.facts.push_back({"within limits", static_cast<long>(summary.within_limits), ""});
  }
  Document told = documentOf(summary, work.inputs, options.common.format);
  document.tables = std::move(told.tables);
  document.remarks.insert(document.remarks.end(), told.remarks.begin(), told.remarks.end());
  if (!options.csv.empty()) database.writeCsv(options.csv);
  std::vector<std::string> written;
  if (!options.best_folder.empty()) written = writeBest(options.best_folder, summary, work.inputs);
  print(document, options.common.format, std::cout);
  if (options.common.quiet) return;
  if (!options.csv.empty()) std::cerr << fmt::format("written: {}\n", options.csv);
  for (const std::string& each : written) std::cerr << fmt::format("written: {}\n", each);
}

Document headOf(const StudyWork& work, const std::string& database) {
  Document document;
  document.facts = {{"study", work.inputs.study.name, ""},
                    {"vehicle", work.inputs.vehicle.name, ""},
                    {"database", database, ""}};
  return document;
}

}  // namespace

int runStudyFile(const StudyOptions& options) {
  const std::unique_ptr<Executor> executor = executorOf(options);
  if (!executor->leads()) return help(options, *executor);
  const StudyWork work = readStudyWork(options.study);
  Document document = headOf(work, options.database);
  document.remarks.push_back(StudyEvaluator(work.inputs).path().text);

  const StudyOutcome outcome = evaluate(options, work, *executor);
  const StudyProgress& done = outcome.progress;
  document.facts.insert(document.facts.end(), {{"threads", static_cast<long>(executor->threads()), ""},
                                               {"evaluated now", static_cast<long>(done.evaluated), ""},
                                               {"time", done.seconds, "s"}});
  if (done.evaluated > 0) {
    document.facts.push_back({"rate", static_cast<double>(done.evaluated) / done.seconds, "designs/s"});
  }
  show(options, options.database, work, std::move(document));
  if (outcome.ending == Ending::kFinished) return kDone;
  std::cerr << fmt::format("vehicle: interrupted; {} of {} designs are kept. Go on with:\n  vehicle study {} --output {} --resume\n",
                           done.before + done.evaluated, done.designs, options.study, options.database);
  return kInterrupted;
}

int showStudy(const StudyOptions& options) {
  const StudyRecord record = StudyDatabase::read(options.shown).record();
  const StudyWork work = restoreStudyWork(record);
  Document document = headOf(work, options.shown);
  document.facts.push_back({"written by", record.program, ""});
  show(options, options.shown, work, std::move(document));
  return kDone;
}

}  // namespace vehicle::cli
