#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "libvehicle/integrate/dopri5.h"
#include "libvehicle/integrate/drive.h"
#include "libvehicle/integrate/failure.h"
#include "libvehicle/integrate/step_control.h"

namespace vehicle {

/// A Dopri5 that chooses its steps: they end on the borders of the input's segments and nowhere else by force; the
/// samples between come from the dense output, so a fine output costs no steps.
///
/// @tparam Stepper  Dopri5 over some right-hand side and size
template <class Stepper>
class AdaptiveSteps final : public DrivenAsCopy<AdaptiveSteps<Stepper>> {
 public:
  /// @throws std::invalid_argument  for a wrong accuracy (checkAccuracy)
  AdaptiveSteps(Stepper stepper, const Input& input, Accuracy accuracy)
      : stepper_(std::move(stepper)),
        input_(&input),
        accuracy_(accuracy),
        width_(2 * input.channels()),
        u_(kDopri5.c.size() * static_cast<std::size_t>(width_)),
        state_(static_cast<std::size_t>(stepper_.size())),
        control_(Stepper::kOrder) {
    checkAccuracy(Stepper::kName, accuracy);
  }

  void restart(const Interval& at, std::span<const double> x) override {
    checkStart(Stepper::kName, x, stepper_.size());
    std::copy(x.begin(), x.end(), state_.begin());
    t_ = at.begin;
    segment_ = -1;
    in_step_ = false;
    control_ = StepControl(Stepper::kOrder);
    next_step_ = 0.0;
    // Below this a step no longer moves the clock reliably.
    const double latest = std::max(std::abs(input_->begin()), std::abs(input_->end()));
    least_step_ = 16.0 * std::numeric_limits<double>::epsilon() * latest;
  }

  void advance(const Interval& interval) override {
    if (interval.segment != segment_) enter(interval);
    while (!reaches(interval.end)) {
      leaveStep();
      makeStep();
    }
    if (interval.end == segment_end_) {
      leaveStep();
      std::copy_n(stepper_.state(), stepper_.size(), state_.begin());
    } else {
      stepper_.dense(std::min(1.0, (interval.end - t_) / h_), state_.data());
    }
  }

  [[nodiscard]] std::span<const double> state() const override { return state_; }
  [[nodiscard]] Statistics statistics() const override { return statistics_; }

 private:
  // A segment begins where the one before ended; state_ is the state there.
  void enter(const Interval& first) {
    segment_ = first.segment;
    segment_end_ = first.segment_end;
    input_->evaluate(segment_, t_, inputRow(0));
    stepper_.begin(state_.data(), inputRow(0).data());
    ++statistics_.evaluations;
    requireFinite(Stepper::kName, t_, {stepper_.slope(), state_.size()});
    longest_ = std::min(longestStep(input_->segment(segment_)), segment_end_ - t_);
    if (accuracy_.max_step > 0.0) longest_ = std::min(longest_, accuracy_.max_step);
    if (next_step_ == 0.0) next_step_ = firstStep(longest_);
  }

  // Whether the step in hand covers that time of the segment.
  [[nodiscard]] bool reaches(double t) const { return in_step_ && (arrives_ || t <= t_ + h_); }

  // To the end of the step in hand, if there is one.
  void leaveStep() {
    if (!in_step_) return;
    in_step_ = false;
    stepper_.accept();
    t_ = arrives_ ? segment_end_ : t_ + h_;
    // A step cut short by the breakpoint says little about the size that the tolerance would have allowed.
    next_step_ = h_ < next_step_ ? std::max(next_step_, after_) : after_;
  }

  // A step from t_ that the tolerance accepts.
  void makeStep() {
    const double remaining = segment_end_ - t_;
    do {
      const double wanted = std::min(next_step_, longest_);
      // The last two steps share what is left, so that no sliver remains for the very last.
      h_ = wanted >= 0.99 * remaining ? remaining : std::min(wanted, 0.5 * std::max(remaining, wanted));
    } while (!attempt());
    arrives_ = h_ == remaining;
    in_step_ = true;
  }

  bool attempt() {
    for (std::size_t i = 1; i < kDopri5.c.size(); ++i) input_->evaluate(segment_, t_ + kDopri5.c[i] * h_, inputRow(i));
    stepper_.attempt(h_, u_.data(), width_);
    statistics_.evaluations += Stepper::kEvaluations;
    const double norm = stepper_.errorNorm(accuracy_.absolute, accuracy_.relative);
    if (norm <= 1.0) {
      after_ = control_.afterAccepted(h_, norm);
      if (++statistics_.steps == kMostSteps) failRun(Stepper::kName, t_, "the run needs more than 1e8 steps; it stood");
      return true;
    }
    ++statistics_.rejected;
    next_step_ = control_.afterRejected(h_, norm);
    if (next_step_ < least_step_) {
      failRun(Stepper::kName, t_,
              std::isfinite(norm) ? "the step size fell to rounding level (tolerances too tight, or a singularity)"
                                  : "dx/dt is not finite however small the step");
    }
    return false;
  }

  // From the sizes of x, f and a difference of f.
  // Source: Hairer, Norsett, Wanner I, 2nd ed., II.4, "Starting Step Size".
  double firstStep(double longest) {
    const int n = stepper_.size();
    const double* x = stepper_.state();
    const double* f = stepper_.slope();
    const auto norm = [&](const auto& value) {
      double sum = 0.0;
      for (int i = 0; i < n; ++i) {
        const double ratio = value(i) / (accuracy_.absolute + accuracy_.relative * std::abs(x[i]));
        sum += ratio * ratio;
      }
      return std::sqrt(sum / n);
    };
    const double d0 = norm([&](int i) { return x[i]; });
    const double d1 = norm([&](int i) { return f[i]; });
    const double trial = std::min(d0 < 1e-5 || d1 < 1e-5 ? 1e-6 : 0.01 * d0 / d1, longest);
    std::vector<double> moved(state_.size());
    std::vector<double> slope(state_.size());
    for (int i = 0; i < n; ++i) moved[static_cast<std::size_t>(i)] = x[i] + trial * f[i];
    input_->evaluate(segment_, t_ + trial, inputRow(1));
    stepper_.rhs()(moved.data(), inputRow(1).data(), slope.data());
    ++statistics_.evaluations;
    const double d2 = norm([&](int i) { return slope[static_cast<std::size_t>(i)] - f[i]; }) / trial;
    const double steepest = std::max(d1, d2);
    if (!std::isfinite(steepest)) return trial;
    const double step =
        steepest <= 1e-15 ? std::max(1e-6, 1e-3 * trial) : std::pow(0.01 / steepest, 1.0 / Stepper::kOrder);
    return std::max(std::min(step, 100.0 * trial), 2.0 * least_step_);
  }

  std::span<double> inputRow(std::size_t row) {
    return {u_.data() + row * static_cast<std::size_t>(width_), static_cast<std::size_t>(width_)};
  }

  static constexpr long kMostSteps = 100'000'000;

  Stepper stepper_;
  const Input* input_;
  Accuracy accuracy_;
  int width_;
  std::vector<double> u_;      // (7 x width) the input at the stages
  std::vector<double> state_;  // (n) at the end of the last interval
  StepControl control_;
  Statistics statistics_;
  double least_step_ = 0.0;

  int segment_ = -1;
  double segment_end_ = 0.0;
  double longest_ = 0.0;
  double t_ = 0.0;  // where the stepper stands: at the begin of the step in hand
  double h_ = 0.0;
  bool in_step_ = false;    // a step of h_ is made and not left yet
  bool arrives_ = false;    // it ends the segment
  double after_ = 0.0;      // size that its error allows the next
  double next_step_ = 0.0;  // 0: none tried yet
};

}  // namespace vehicle
