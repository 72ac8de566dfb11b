#include "libvehicle/mbs/simbody_steps.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"

namespace vehicle {

SimbodySteps::SimbodySteps(SimbodyModel& model, const RunProblem& problem, double accuracy)
    : model_(model), problem_(problem), accuracy_(accuracy) {
  if (!(accuracy > 0.0 && accuracy < 1.0)) {
    throw std::invalid_argument(fmt::format("simbody_rkm: accuracy = {}, must be > 0 and < 1", accuracy));
  }
  if (problem.input.channels() != problem.system.channels()) {
    throw std::invalid_argument(fmt::format("simbody_rkm: the input has {} wheelsets, must be {}",
                                            problem.input.channels(), problem.system.channels()));
  }
}

// Only what Simbody throws is reported as a failure of the integrator; an observer's exceptions pass untouched.
template <class Call>
void SimbodySteps::simbody(Call call) const {
  try {
    call();
  } catch (const std::exception& failure) {
    throw RunFailed(fmt::format("simbody_rkm: gave up after t = {} s: {}", reached_, failure.what()));
  }
}

void SimbodySteps::restart(const Interval& at, std::span<const double> x) {
  if (static_cast<int>(x.size()) != problem_.system.size()) {
    throw std::invalid_argument(
        fmt::format("simbody_rkm: the initial state has {} numbers, must be {}", x.size(), problem_.system.size()));
  }
  x_.assign(x.begin(), x.end());
  segment_ = at.segment;
  reached_ = at.begin;
  requireNumbers();
  const auto rail = [this, size = 2 * static_cast<std::size_t>(problem_.input.channels())](double t, double* u) {
    problem_.input.evaluate(segment_, t, {u, size});
  };
  simbody([&] { model_.startRun(accuracy_, problem_.schedule.outputStep(), reached_, x_.data(), rail); });
}

void SimbodySteps::advance(const Interval& interval) {
  if (interval.segment != segment_) {
    segment_ = interval.segment;
    model_.passBreakpoint();
  }
  simbody([&] { model_.advanceTo(interval.end); });
  reached_ = interval.end;
  if (interval.sample < 0) return;
  model_.readState(x_.data());
  requireNumbers();
}

Statistics SimbodySteps::statistics() const {
  const SimbodyCost cost = model_.cost();
  return {.steps = cost.steps, .evaluations = cost.evaluations, .rejected = cost.rejected};
}

void SimbodySteps::requireNumbers() const {
  for (std::size_t i = 0; i < x_.size(); ++i) {
    if (std::isfinite(x_[i])) continue;
    throw RunFailed(
        fmt::format("simbody_rkm: {} is {} at t = {} s", problem_.system.states()[i].name, x_[i], reached_));
  }
}

}  // namespace vehicle
