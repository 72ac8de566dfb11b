#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "libvehicle/storage/study_database.h"
#include "libvehicle/study/evaluate/study_evaluator.h"
#include "libvehicle/study/execute/executor.h"
#include "libvehicle/study/plan/design_plan.h"

namespace vehicle {

/// How far a study is.
struct StudyProgress {
  std::uint64_t designs = 0;    // of the whole study
  std::uint64_t before = 0;     // stored when this run began
  std::uint64_t evaluated = 0;  // by this run
  std::uint64_t failed = 0;     // of those
  double seconds = 0.0;         // since this run began
};

/// Called about twenty times a second on the calling thread, and once at the end; returning false ends the run with
/// what is done stored.
using StudyWatch = std::function<bool(const StudyProgress&)>;

struct StudyOutcome {
  StudyProgress progress;
  Ending ending = Ending::kFinished;
};

/// Puts an evaluated design among those that are to be stored.
void add(const EvaluatedDesign& design, DesignBatch& batch);

/// Evaluates what a database still misses and stores it, some ten thousand designs or two seconds at a time: a run that
/// is killed loses no more than that. Memory does not depend on the number of designs.
/// On a rank that does not lead (executor.leads()) use serve() instead.
/// @param evaluator  rows are the parameters of the database's record, then its metrics
/// @throws std::invalid_argument  if the rows have another width
/// @throws RunFailed              the database can no longer be written; what was stored is safe
/// @throws what ends the work of an executor; what was finished is stored before
StudyOutcome evaluateMissing(StudyDatabase& database, const Evaluator& evaluator, Executor& executor,
                             const StudyWatch& watch = {});

/// The part of a rank that does not lead: evaluates what the leader hands out, until the leader's executor is gone.
void serve(const Evaluator& evaluator, Executor& executor);

/// Where a study's results go.
struct StudyTarget {
  std::filesystem::path database;
  bool resume = false;            // go on with the file if it is there
  std::string program;            // name and version, kept in the file
  std::vector<InputFile> inputs;  // the study file first, as they were read
  bool overwrite = false;         // begin anew where the file is a study already
};

/// What a study's database says of itself.
[[nodiscard]] StudyRecord recordOf(const DesignPlan& plan, const StudyTarget& target);

/// The target's database: with `resume` an old one if it is there, else a new one.
/// @throws InvalidInput, RunFailed  as StudyDatabase::resume(), replace() and create()
[[nodiscard]] StudyDatabase openOrCreate(const StudyTarget& target, const StudyRecord& record);

/// Runs the designs of a plan: a new database, or with `resume` an old one of the same study, of which only what is
/// missing is evaluated. The table depends on the study alone, not on threads, ranks, or how often it was interrupted.
/// @param inputs  bound as the plan's study
/// @throws InvalidInput  the study cannot be evaluated, or the database holds another study (with the difference)
/// @throws RunFailed     the database exists (without resume), or cannot be written
StudyOutcome runStudy(const StudyInputs& inputs, const DesignPlan& plan, const StudyTarget& target, Executor& executor,
                      const StudyWatch& watch = {});

}  // namespace vehicle
