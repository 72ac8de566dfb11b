#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "libvehicle/study/evaluate/evaluation.h"
#include "libvehicle/study/evaluate/path.h"
#include "libvehicle/study/study_inputs.h"

namespace vehicle {

/// Parameter values of a design, from its number alone; callable from several threads at once.
/// @param values  [SI] (parameters)
using DesignValues = std::function<void(std::int64_t design, std::span<double> values)>;

/// Evaluates the designs of a study. A row holds the values of the parameters, then the metrics: parameterColumns() and
/// metricColumns().
///
/// The path is chosen once for the whole study, by what it asks for (choosePath()); path().text says which and why.
/// A design that cannot be (check() of its vehicle or scenarios) or that moves beyond all bounds is that design's
/// failure. A metric that has no value (a mode that does not oscillate, a band without a line, a number that is not
/// finite) is NaN with its reason among the batch's gaps; the design's other metrics stand.
class StudyEvaluator : public Evaluator {
 public:
  /// @param inputs  outlives the evaluator
  /// @param values  empty: every task tells its designs' values (given() numbers each), as an optimiser chooses them
  /// @throws InvalidInput, std::invalid_argument  if no design of this study can be evaluated (a settle longer than the
  ///         run, a steady state over a dip)
  explicit StudyEvaluator(const StudyInputs& inputs, DesignValues values = {});

  [[nodiscard]] const PathChoice& path() const { return path_; }
  [[nodiscard]] std::size_t columns() const override { return parameters_ + metrics_; }
  [[nodiscard]] std::size_t given() const override { return values_ ? 0 : parameters_; }
  [[nodiscard]] std::int64_t batchSize() const override { return batch_; }
  [[nodiscard]] std::unique_ptr<Worker> worker() const override;

 private:
  const StudyInputs& inputs_;
  DesignValues values_;
  PathChoice path_;
  std::size_t parameters_;
  std::size_t metrics_;
  std::int64_t batch_ = 1;
};

}  // namespace vehicle
