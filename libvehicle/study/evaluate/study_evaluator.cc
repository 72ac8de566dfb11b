#include "libvehicle/study/evaluate/study_evaluator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "libvehicle/study/evaluate/flat_designs.h"
#include "libvehicle/study/evaluate/gap_message.h"
#include "libvehicle/study/evaluate/rest_and_modes.h"

namespace vehicle {

namespace {

/// Designs in one call: enough to fill lanes and to spread the cost of a rail, few enough for a cache.
std::int64_t batchOf(const StudyInputs& inputs, PathChoice::Kind kind) {
  if (kind != PathChoice::Kind::kSteadyEnsemble && kind != PathChoice::Kind::kEnsembleRuns) return 1;
  // A rail for each design and case weighs some kilobytes.
  const bool own_rails = !scenariosAreFixed(inputs.bound) || !FlatDesigns(inputs).geometryIsFixed();
  switch (kind) {
    case PathChoice::Kind::kSteadyEnsemble:
      return own_rails ? 64 : 512;
    case PathChoice::Kind::kEnsembleRuns:
      return own_rails ? 32 : 128;
    default:
      return 1;
  }
}

class StudyWorker final : public Worker {
 public:
  StudyWorker(const StudyInputs& inputs, const DesignValues& values, PathChoice::Kind kind)
      : values_(values),
        parameters_(inputs.bound.parameters.size()),
        path_(makePath(inputs, kind)),
        rest_and_modes_(inputs) {
    for (MetricColumn& each : metricColumns(inputs.bound)) columns_.push_back(std::move(each.channel));
  }

  void evaluate(const Task& task, Batch& batch) override {
    DesignRows rows(batch, parameters_, columns_.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::span<double> parameters = rows.parameters(i);
      if (values_) {
        values_(task.range.first + static_cast<std::int64_t>(i), parameters);
      } else {
        const std::span<const double> given = task.given.subspan(i * parameters_, parameters_);
        std::copy(given.begin(), given.end(), parameters.begin());
      }
    }
    path_->evaluate(rows);
    rest_and_modes_.evaluate(rows);
    for (std::size_t i = 0; i < rows.size(); ++i)
      finish(task.range.first + static_cast<std::int64_t>(i), i, rows, batch);
  }

 private:
  void finish(std::int64_t design, std::size_t row, DesignRows& rows, Batch& batch) const {
    const std::span<double> metrics = rows.metrics(row);
    if (rows.failed(row)) {
      std::fill(metrics.begin(), metrics.end(), std::numeric_limits<double>::quiet_NaN());
      batch.failures.push_back({design, rows.problem(row)});
      return;
    }
    for (std::size_t m = 0; m < metrics.size(); ++m) {
      if (!std::isfinite(metrics[m])) rows.leaveEmpty(row, m, "is not finite");
    }
    if (!rows.warnings(row).empty()) batch.warnings.push_back({design, rows.warnings(row)});
    if (!rows.missing(row).empty()) batch.gaps.push_back({design, gapMessage(columns_, rows.missing(row))});
  }

  const DesignValues& values_;
  std::size_t parameters_;
  std::vector<Channel> columns_;  // (metrics)
  std::unique_ptr<Path> path_;
  RestAndModes rest_and_modes_;
};

}  // namespace

StudyEvaluator::StudyEvaluator(const StudyInputs& inputs, DesignValues values)
    : inputs_(inputs),
      values_(std::move(values)),
      path_(choosePath(inputs)),
      parameters_(inputs.bound.parameters.size()),
      metrics_(metricColumns(inputs.bound).size()),
      batch_(batchOf(inputs, path_.kind)) {
  if (path_.kind != PathChoice::Kind::kSteadyEnsemble && path_.kind != PathChoice::Kind::kEnsembleRuns) return;
  // What is wrong with the study itself shows in the base alone, before a million designs fail of it.
  Batch batch;
  batch.reset({0, 1}, columns());
  DesignRows rows(batch, parameters_, metrics_);
  for (std::size_t i = 0; i < parameters_; ++i) rows.parameters(0)[i] = inputs.bound.parameters[i].base;
  makePath(inputs, path_.kind)->evaluate(rows);
}

std::unique_ptr<Worker> StudyEvaluator::worker() const {
  return std::make_unique<StudyWorker>(inputs_, values_, path_.kind);
}

}  // namespace vehicle
