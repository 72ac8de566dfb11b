#pragma once

#include <utility>
#include <vector>

#include "libvehicle/integrate/drive.h"
#include "libvehicle/integrate/failure.h"
#include "libvehicle/integrate/step_walk.h"

namespace vehicle {

/// The input itself, block by block: rows at half steps, apart from f(x, u).
class SweptInput {
 public:
  explicit SweptInput(const Input& input)
      : input_(&input),
        rows_((2 * static_cast<std::size_t>(kStepsPerBlock) + 1) * 2 * static_cast<std::size_t>(input.channels())) {}

  const double* operator()(const StepBlock& block) {
    block.sweep(*input_, {rows_.data(), static_cast<std::size_t>(block.rows()) * 2 * input_->channels()});
    return rows_.data();
  }

 private:
  const Input* input_;
  std::vector<double> rows_;
};

/// A stepper that is led over a schedule by steps of equal length within each interval: run() is a whole run.
/// A state that is no longer finite is an error at a sample or after a block of steps, naming the time.
///
/// @tparam Stepper  kName, kEvaluations, size() and step(h, u_begin, u_middle, u_end, x) as Rk4 has them
/// @tparam Feed     feed(const StepBlock&): its rows, valid until the next call
template <class Stepper, class Feed = SweptInput>
class FixedSteps final : public DrivenAsCopy<FixedSteps<Stepper, Feed>> {
 public:
  /// @param width  values of a row
  FixedSteps(Stepper stepper, int width, Feed feed, FixedStep step)
      : stepper_(std::move(stepper)),
        feed_(std::move(feed)),
        width_(width),
        cursor_(step),
        x_(static_cast<std::size_t>(stepper_.size())) {}
  /// Fed by the input.
  FixedSteps(Stepper stepper, const Input& input, FixedStep step)
      : FixedSteps(std::move(stepper), 2 * input.channels(), SweptInput(input), step) {}

  void restart(const Interval&, std::span<const double> x) override {
    checkStart(Stepper::kName, x, stepper_.size());
    std::copy(x.begin(), x.end(), x_.begin());
    cursor_.restart();
  }

  void advance(const Interval& interval) override {
    const auto check = [&](double reached) {
      requireFinite(Stepper::kName, reached, x_);
      return true;
    };
    cursor_.advance(
        interval, [&](const StepBlock& block) { row_ = feed_(block); },
        [this, x = x_.data(), width = width_](double h, int) {
          stepper_.step(h, row_, row_ + width, row_ + 2 * width, x);
          row_ += 2 * width;
        },
        check);
    check(cursor_.reached());
  }

  [[nodiscard]] std::span<const double> state() const override { return x_; }
  [[nodiscard]] Statistics statistics() const override {
    return {.steps = cursor_.steps(), .evaluations = Stepper::kEvaluations * cursor_.steps()};
  }

 private:
  Stepper stepper_;
  Feed feed_;
  int width_;
  StepCursor cursor_;
  std::vector<double> x_;
  const double* row_ = nullptr;  // of the next step
};

}  // namespace vehicle
