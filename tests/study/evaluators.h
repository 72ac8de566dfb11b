#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "libvehicle/study/evaluate/evaluation.h"

namespace vehicle::test {

/// Rows by a function of design number and given numbers, so that executors and runners are tested without a vehicle.
/// The function may throw: std::domain_error is the design's failure, everything else ends the study. A number that it
/// makes NaN is a gap. Every 997th design has a warning.
class FunctionEvaluator : public Evaluator {
 public:
  using Function = std::function<void(std::int64_t design, std::span<const double> given, std::span<double> row)>;

  FunctionEvaluator(std::size_t columns, std::int64_t batch, Function function, std::size_t given = 0)
      : columns_(columns), batch_(batch), given_(given), function_(std::move(function)) {}

  [[nodiscard]] std::size_t columns() const override { return columns_; }
  [[nodiscard]] std::size_t given() const override { return given_; }
  [[nodiscard]] std::int64_t batchSize() const override { return batch_; }
  [[nodiscard]] std::unique_ptr<Worker> worker() const override { return std::make_unique<FunctionWorker>(*this); }

 private:
  struct FunctionWorker : Worker {
    explicit FunctionWorker(const FunctionEvaluator& owner) : evaluator(owner) {}
    void evaluate(const Task& task, Batch& batch) override {
      for (std::int64_t design = task.range.first; design < task.range.end; ++design) {
        const auto place = static_cast<std::size_t>(design - task.range.first) * evaluator.given_;
        const std::span<double> row = batch.row(design, evaluator.columns_);
        try {
          evaluator.function_(design, task.given.subspan(place, evaluator.given_), row);
          const auto gap = std::find_if(row.begin(), row.end(), [](double each) { return std::isnan(each); });
          if (gap != row.end()) {
            batch.gaps.push_back({design, "column " + std::to_string(gap - row.begin()) + ": no value"});
          }
          if (design % 997 == 5) {
            batch.warnings.push_back({design, {}});
            batch.warnings.back().warnings.insert(WarningCode::kLargeMotion);
          }
        } catch (const std::domain_error& error) {
          std::fill(row.begin(), row.end(), NAN);
          batch.failures.push_back({design, error.what()});
        }
      }
    }
    const FunctionEvaluator& evaluator;
  };

  std::size_t columns_;
  std::int64_t batch_;
  std::size_t given_;
  Function function_;
};

}  // namespace vehicle::test
