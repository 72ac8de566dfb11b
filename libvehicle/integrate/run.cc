#include "libvehicle/integrate/run.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "libvehicle/integrate/adaptive_run.h"
#include "libvehicle/integrate/dopri5.h"
#include "libvehicle/integrate/fixed_step_run.h"
#include "libvehicle/integrate/rk4.h"
#include "libvehicle/integrate/system_rhs.h"

namespace vehicle {

int stepsOf(double length, FixedStep step) {
  if (!(step.step > 0.0 && std::isfinite(step.step)) || step.refine < 1) {
    std::ostringstream message;
    message << "fixed step: step = " << step.step << " s, must be finite and > 0; refine = " << step.refine
            << ", must be >= 1";
    throw std::invalid_argument(message.str());
  }
  const double whole = std::max(1.0, std::ceil(length / step.step - 1e-9));
  if (!(whole * step.refine < 1e9)) {
    std::ostringstream message;
    message << "fixed step: " << length << " s in steps of " << step.step / step.refine
            << " s are 1e9 steps or more, must be fewer; choose a longer step";
    throw std::invalid_argument(message.str());
  }
  return static_cast<int>(whole) * step.refine;
}

StepGrid stepGridAt(const Schedule& schedule, std::size_t first, FixedStep step) {
  const Interval begin = schedule.intervals()[first];
  StepGrid grid;
  const double length = begin.whole > 0.0 ? begin.whole : begin.end - begin.begin;
  grid.steps = stepsOf(length, step);
  grid.h = length / grid.steps;
  constexpr std::size_t kMostSteps = 100'000'000;  // so that half steps are counted by an int
  const std::size_t most = std::max<std::size_t>(1, kMostSteps / static_cast<std::size_t>(grid.steps));
  grid.count = std::clamp<std::size_t>(schedule.wholeFrom(first), 1, most);
  return grid;
}

Statistics runRk4(const System& system, const Input& input, const Schedule& schedule, FixedStep step,
                  std::span<const double> x0, const Observer& observe) {
  checkChannels("rk4", system.channels(), input.channels());
  Rk4<SystemRhs> stepper(SystemRhs(system), system.size());
  return runFixedStep(stepper, input, schedule, step, x0, observe);
}

Statistics runDopri5(const System& system, const Input& input, const Schedule& schedule, Accuracy accuracy,
                     std::span<const double> x0, const Observer& observe) {
  checkChannels("dopri5", system.channels(), input.channels());
  Dopri5<SystemRhs> stepper(SystemRhs(system), system.size());
  return runAdaptive(stepper, input, schedule, accuracy, x0, observe);
}

}  // namespace vehicle
