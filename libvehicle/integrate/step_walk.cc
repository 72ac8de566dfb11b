#include "libvehicle/integrate/step_walk.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

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

StepGrid stepGridFrom(const Interval& interval, FixedStep step) {
  StepGrid grid{.segment = interval.segment, .begin = interval.begin};
  const double length = interval.whole > 0.0 ? interval.whole : interval.end - interval.begin;
  grid.steps = stepsOf(length, step);
  grid.h = length / grid.steps;
  constexpr std::size_t kMostSteps = 100'000'000;  // so that half steps are counted by an int
  const std::size_t most = std::max<std::size_t>(1, kMostSteps / static_cast<std::size_t>(grid.steps));
  grid.count = static_cast<int>(std::clamp<std::size_t>(interval.alike, 1, most));
  return grid;
}

}  // namespace vehicle
