#pragma once

#include <algorithm>
#include <vector>

#include "libvehicle/integrate/failure.h"
#include "libvehicle/integrate/run.h"

namespace vehicle {

/// Number of equal steps of a stretch: the fewest that are not above step.step, then each cut in step.refine.
/// A length that exceeds a multiple of the step by rounding alone does not cost one more.
/// @param length  [s] > 0
/// @throws std::invalid_argument unless step.step > 0 and finite, step.refine >= 1, and the number is below 1e9
[[nodiscard]] int stepsOf(double length, FixedStep step);

/// Steps that are fed with one block of input. A multiple of Input::kBlock / 2, so that blocks begin where the
/// input is seeded anew and the cut leaves no trace in the numbers.
inline constexpr int kStepsPerBlock = 2 * Input::kBlock;

/// Kink-exact run of a stepper with steps of equal length within each stretch of the schedule.
///
/// Every stretch lies inside one segment of the input and is run with that segment's formula to its very end, so
/// no step sees a kink and the limits at both ends are the one-sided ones. The input is asked in blocks at half
/// steps, apart from f(x, u).
///
/// @tparam Stepper  kName, kEvaluations and step(h, u_begin, u_middle, u_end, x) as Rk4 has them
/// @param x0  (n) state at the schedule's first sample
/// @throws std::runtime_error     if a state is no longer finite at the end of a block, naming the time
/// @throws std::invalid_argument  for a wrong step (stepsOf) or x0 (checkStart)
template <class Stepper>
Statistics runFixedStep(Stepper& stepper, const Input& input, const Schedule& schedule, FixedStep step,
                        std::span<const double> x0, const Observer& observe) {
  checkStart(Stepper::kName, x0, stepper.size());
  std::vector<double> x(x0.begin(), x0.end());
  const int width = 2 * input.channels();
  std::vector<double> u((2 * static_cast<std::size_t>(kStepsPerBlock) + 1) * static_cast<std::size_t>(width));

  Statistics statistics;
  const Stretch& first = schedule.stretches().front();
  if (!observe(0, first.segment, first.begin, x)) {
    statistics.stopped = true;
    return statistics;
  }
  for (const Stretch& stretch : schedule.stretches()) {
    const int steps = stepsOf(stretch.end - stretch.begin, step);
    const double h = (stretch.end - stretch.begin) / steps;
    for (int done = 0; done < steps; done += kStepsPerBlock) {
      const int count = std::min(kStepsPerBlock, steps - done);
      const int values = 2 * count + 1;
      input.sweep(stretch.segment, stretch.begin, 0.5 * h, 2 * done, values,
                  {u.data(), static_cast<std::size_t>(values * width)});
      const double* row = u.data();
      for (int i = 0; i < count; ++i, row += 2 * width) {
        stepper.step(h, row, row + width, row + 2 * width, x.data());
      }
      requireFinite(Stepper::kName, stretch.begin + (done + count) * h, x);
    }
    statistics.steps += steps;
    if (stretch.sample >= 0 && !observe(stretch.sample, stretch.next, stretch.end, x)) {
      statistics.stopped = true;
      break;
    }
  }
  statistics.evaluations = Stepper::kEvaluations * statistics.steps;
  return statistics;
}

}  // namespace vehicle
