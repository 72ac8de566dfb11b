#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "libvehicle/integrate/dopri5.h"
#include "libvehicle/integrate/failure.h"
#include "libvehicle/integrate/step_control.h"

namespace vehicle {

/// Breakpoint-exact adaptive run of a Dopri5: steps end on the borders of the input's segments and nowhere else by force;
/// the samples between come from the dense output, so a fine output costs no steps.
///
/// @tparam Stepper  Dopri5 over some right-hand side and size
template <class Stepper>
class AdaptiveRun {
 public:
  AdaptiveRun(Stepper& stepper, const Input& input, Accuracy accuracy, const Observer& observe)
      : stepper_(stepper), input_(input), accuracy_(accuracy), observe_(observe), width_(2 * input.channels()),
        u_(kDopri5.c.size() * static_cast<std::size_t>(width_)), sample_(static_cast<std::size_t>(stepper.size())),
        control_(Stepper::kOrder) {}

  Statistics run(const Schedule& schedule, std::span<const double> x0) {
    const std::vector<Schedule::Part>& parts = schedule.parts();
    std::copy(x0.begin(), x0.end(), sample_.begin());
    t_ = parts.front().begin;
    // Below this a step no longer moves the clock reliably.
    const double latest = std::max(std::abs(t_), std::abs(parts.back().end));
    least_step_ = 16.0 * std::numeric_limits<double>::epsilon() * latest;
    statistics_.stopped = !observe_(0, parts.front().segment, t_, sample_);
    const Schedule::Intervals intervals = schedule.intervals();
    auto next = intervals.begin();
    for (std::size_t i = 0; i < parts.size() && !statistics_.stopped;) {
      std::size_t last = i;
      while (last + 1 < parts.size() && parts[last + 1].segment == parts[i].segment) ++last;
      runSegment(next, parts[last].end);
      i = last + 1;
    }
    return statistics_;
  }

 private:
  // All intervals of one segment; sample_ holds the state at its begin, and at its end when this returns.
  // @param next  the first of them; behind the last when this returns
  void runSegment(Schedule::Iterator& next, double end) {
    Interval interval = *next;
    const int segment = interval.segment;
    input_.evaluate(segment, t_, inputRow(0));
    stepper_.begin(sample_.data(), inputRow(0).data());
    ++statistics_.evaluations;
    requireFinite(Stepper::kName, t_, {stepper_.slope(), sample_.size()});
    double longest = std::min(longestStep(input_.segment(segment)), end - t_);
    if (accuracy_.max_step > 0.0) longest = std::min(longest, accuracy_.max_step);
    if (next_step_ == 0.0) next_step_ = firstStep(segment, longest);

    while (t_ < end) {
      const double remaining = end - t_;
      const double wanted = std::min(next_step_, longest);
      // The last two steps share what is left, so that no sliver remains for the very last.
      const double h = wanted >= 0.99 * remaining ? remaining : std::min(wanted, 0.5 * std::max(remaining, wanted));
      if (!attempt(segment, h)) continue;
      const bool arrived = h == remaining;
      while (interval.end < end && (arrived || interval.end <= t_ + h)) {
        stepper_.dense(std::min(1.0, (interval.end - t_) / h), sample_.data());
        if (!show(interval)) return;
        ++next;
        interval = *next;
      }
      stepper_.accept();
      t_ = arrived ? end : t_ + h;
      // A step cut short by the breakpoint says little about the size that the tolerance would have allowed.
      next_step_ = h < next_step_ ? std::max(next_step_, after_) : after_;
    }
    std::copy_n(stepper_.state(), stepper_.size(), sample_.begin());
    show(interval);
    ++next;
  }

  bool attempt(int segment, double h) {
    for (std::size_t i = 1; i < kDopri5.c.size(); ++i) input_.evaluate(segment, t_ + kDopri5.c[i] * h, inputRow(i));
    stepper_.attempt(h, u_.data(), width_);
    statistics_.evaluations += Stepper::kEvaluations;
    const double norm = stepper_.errorNorm(accuracy_.absolute, accuracy_.relative);
    if (norm <= 1.0) {
      after_ = control_.afterAccepted(h, norm);
      if (++statistics_.steps == kMostSteps) failRun(Stepper::kName, t_, "the run needs more than 1e8 steps; it stood");
      return true;
    }
    ++statistics_.rejected;
    next_step_ = control_.afterRejected(h, norm);
    if (next_step_ < least_step_) {
      failRun(Stepper::kName, t_,
              std::isfinite(norm) ? "the step size fell to rounding level (tolerances too tight, or a singularity)"
                                  : "dx/dt is not finite however small the step");
    }
    return false;
  }

  // From the sizes of x, f and a difference of f.
  // Source: Hairer, Norsett, Wanner I, 2nd ed., II.4, "Starting Step Size".
  double firstStep(int segment, double longest) {
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
    std::vector<double> moved(sample_.size());
    std::vector<double> slope(sample_.size());
    for (int i = 0; i < n; ++i) moved[static_cast<std::size_t>(i)] = x[i] + trial * f[i];
    input_.evaluate(segment, t_ + trial, inputRow(1));
    stepper_.rhs()(moved.data(), inputRow(1).data(), slope.data());
    ++statistics_.evaluations;
    const double d2 = norm([&](int i) { return slope[static_cast<std::size_t>(i)] - f[i]; }) / trial;
    const double steepest = std::max(d1, d2);
    if (!std::isfinite(steepest)) return trial;
    const double step =
        steepest <= 1e-15 ? std::max(1e-6, 1e-3 * trial) : std::pow(0.01 / steepest, 1.0 / Stepper::kOrder);
    return std::max(std::min(step, 100.0 * trial), 2.0 * least_step_);
  }

  bool show(const Interval& interval) {
    if (interval.sample < 0) return true;
    statistics_.stopped = !observe_(interval.sample, interval.next, interval.end, sample_);
    return !statistics_.stopped;
  }

  std::span<double> inputRow(std::size_t row) {
    return {u_.data() + row * static_cast<std::size_t>(width_), static_cast<std::size_t>(width_)};
  }

  static constexpr long kMostSteps = 100'000'000;

  Stepper& stepper_;
  const Input& input_;
  Accuracy accuracy_;
  const Observer& observe_;
  int width_;
  std::vector<double> u_;       // (7 x width) the input at the stages
  std::vector<double> sample_;  // (n)
  StepControl control_;
  Statistics statistics_;
  double t_ = 0.0;
  double least_step_ = 0.0;
  double next_step_ = 0.0;  // 0: none tried yet
  double after_ = 0.0;
};

/// @throws std::runtime_error     where dx/dt leaves the numbers or the step falls to rounding level, with the time
/// @throws std::invalid_argument  for a wrong accuracy (checkAccuracy) or x0 (checkStart)
template <class Stepper>
Statistics runAdaptive(Stepper& stepper, const Input& input, const Schedule& schedule, Accuracy accuracy,
                       std::span<const double> x0, const Observer& observe) {
  checkAccuracy(Stepper::kName, accuracy);
  checkStart(Stepper::kName, x0, stepper.size());
  return AdaptiveRun<Stepper>(stepper, input, accuracy, observe).run(schedule, x0);
}

}  // namespace vehicle
