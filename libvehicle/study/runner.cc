#include "libvehicle/study/runner.h"

#include <chrono>
#include <stdexcept>
#include <utility>

namespace vehicle {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kDesignsOfAppend = 10'000;  // the database's cheapest batch
constexpr std::chrono::seconds kMostBetweenAppends{2};

/// Gathers results and stores them in large batches.
class Store {
 public:
  Store(StudyDatabase& database, std::size_t parameters, std::size_t metrics)
      : database_(database), parameters_(parameters), metrics_(metrics), waiting_(parameters, metrics) {}

  void take(Batch& batch) {
    batch.forEach(parameters_ + metrics_, [this](const EvaluatedDesign& each) {
      add(each, waiting_);
      failed += each.failed ? 1 : 0;
      ++evaluated;
    });
    if (waiting_.size() >= kDesignsOfAppend) flush();
  }

  void flushIfOld() {
    if (Clock::now() - flushed_ >= kMostBetweenAppends) flush();
  }

  void flush() {
    flushed_ = Clock::now();
    if (waiting_.size() == 0) return;
    database_.append(waiting_);
    waiting_.clear();
  }

  std::uint64_t evaluated = 0;
  std::uint64_t failed = 0;

 private:
  StudyDatabase& database_;
  std::size_t parameters_;
  std::size_t metrics_;
  DesignBatch waiting_;
  Clock::time_point flushed_ = Clock::now();
};

Workload missingIn(const StudyDatabase& database) {
  Workload workload;
  for (const DesignRange& each : database.missing()) {
    workload.ranges.push_back({static_cast<std::int64_t>(each.first), static_cast<std::int64_t>(each.last) + 1});
  }
  return workload;
}

}  // namespace

void add(const EvaluatedDesign& design, DesignBatch& batch) {
  const auto id = static_cast<std::uint64_t>(design.design);
  const std::span<const double> parameters = design.row.first(batch.parameters());
  if (design.failed) {
    batch.addFailed(id, parameters, std::string(design.message));
  } else {
    batch.add(id, parameters, design.row.subspan(batch.parameters()), std::string(design.message), design.warnings);
  }
}

StudyOutcome evaluateMissing(StudyDatabase& database, const Evaluator& evaluator, Executor& executor,
                             const StudyWatch& watch) {
  const StudyRecord& record = database.record();
  const std::size_t width = record.parameters.size() + record.metrics.size();
  if (evaluator.columns() != width) {
    throw std::invalid_argument("the evaluator gives rows of " + std::to_string(evaluator.columns()) +
                                " numbers, the database holds " + std::to_string(width));
  }
  const auto begin = Clock::now();
  Store store(database, record.parameters.size(), record.metrics.size());
  StudyOutcome outcome;
  outcome.progress.designs = record.designs;
  outcome.progress.before = database.stored();
  const auto report = [&] {
    outcome.progress.evaluated = store.evaluated;
    outcome.progress.failed = store.failed;
    outcome.progress.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    return !watch || watch(outcome.progress);
  };
  bool storing = false;  // an exception now comes from the database, which may not be asked again
  const Sink sink = [&](Batch& batch) {
    storing = true;
    store.take(batch);
    storing = false;
  };
  const GoOn go_on = [&] {
    storing = true;
    store.flushIfOld();
    storing = false;
    return report();
  };
  try {
    outcome.ending = executor.run(evaluator, missingIn(database), sink, go_on);
  } catch (...) {
    if (!storing) store.flush();
    throw;
  }
  store.flush();
  report();
  return outcome;
}

void serve(const Evaluator& evaluator, Executor& executor) {
  executor.run(evaluator, {}, [](Batch&) {});
}

StudyRecord recordOf(const DesignPlan& plan, const StudyTarget& target) {
  StudyRecord record;
  record.program = target.program;
  record.inputs = target.inputs;
  record.parameters = parameterColumns(plan.study());
  for (const MetricColumn& each : metricColumns(plan.study())) record.metrics.push_back(each.channel);
  record.designs = plan.size();
  return record;
}

StudyDatabase openOrCreate(const StudyTarget& target, const StudyRecord& record) {
  const bool goes_on = target.resume && std::filesystem::exists(target.database);
  if (goes_on) return StudyDatabase::resume(target.database, record);
  return target.overwrite ? StudyDatabase::replace(target.database, record)
                          : StudyDatabase::create(target.database, record);
}

StudyOutcome runStudy(const StudyInputs& inputs, const DesignPlan& plan, const StudyTarget& target, Executor& executor,
                      const StudyWatch& watch) {
  const StudyEvaluator evaluator(inputs, [&plan](std::int64_t design, std::span<double> values) {
    plan.valuesOf(static_cast<std::uint64_t>(design), values);
  });
  if (!executor.leads()) {
    serve(evaluator, executor);
    return {};
  }
  StudyDatabase database = openOrCreate(target, recordOf(plan, target));
  return evaluateMissing(database, evaluator, executor, watch);
}

}  // namespace vehicle
