#pragma once

#include <algorithm>
#include <vector>

#include "libvehicle/integrate/failure.h"
#include "libvehicle/integrate/run.h"

namespace vehicle {

/// Number of equal steps of an interval: the fewest that are not above step.step, then each cut in step.refine.
/// A length that exceeds a multiple of the step by rounding alone does not cost one more.
/// @param length  [s] > 0
/// @throws std::invalid_argument unless step.step > 0 and finite, step.refine >= 1, and the number is below 1e9
[[nodiscard]] int stepsOf(double length, FixedStep step);

/// Intervals first .. first+count-1 of a schedule, run as one grid of equal steps.
struct StepGrid {
  std::size_t count = 1;
  int steps = 0;   // of each interval
  double h = 0.0;  // [s]
};

/// The longest grid that begins with that interval. Intervals of one whole output step in one segment of the input
/// share a grid: the sine and cosine that seed the input are then paid once a block and not once a sample.
[[nodiscard]] StepGrid stepGridAt(const Schedule& schedule, std::size_t first, FixedStep step);

/// Steps that are fed with one block of input. A multiple of Input::kBlock / 2, so that blocks begin where the
/// input is seeded anew and the cut leaves no trace in the numbers.
inline constexpr int kStepsPerBlock = 2 * Input::kBlock;

/// Breakpoint-exact run of a stepper with steps of equal length within each interval of the schedule.
///
/// Every interval lies inside one segment of the input and is run with that segment's formula to its very end, so
/// no step sees a breakpoint and the limits at both ends are the one-sided ones. The input is asked in blocks at half
/// steps, apart from f(x, u).
///
/// @tparam Stepper  kName, kEvaluations and step(h, u_begin, u_middle, u_end, x) as Rk4 has them
/// @tparam Feed     feed(segment, begin, h, first, last): rows of u at the half steps of the steps first .. last-1 of
///                  the grid that begins at `begin`, 2 (last - first) + 1 of them, valid until the next call
/// @param width     values of a row
/// @param x0  (n) state at the schedule's first sample
/// @throws std::runtime_error     if a state is no longer finite at a sample or the end of a block, naming the time
/// @throws std::invalid_argument  for a wrong step (stepsOf) or x0 (checkStart)
template <class Stepper, class Feed>
Statistics runFedSteps(Stepper& stepper, int width, Feed feed, const Schedule& schedule, FixedStep step,
                       std::span<const double> x0, const Observer& observe) {
  checkStart(Stepper::kName, x0, stepper.size());
  std::vector<double> x(x0.begin(), x0.end());
  const Schedule::Intervals intervals = schedule.intervals();
  auto next = intervals.begin();

  Statistics statistics;
  Interval interval = *next;
  statistics.stopped = !observe(0, interval.segment, interval.begin, x);
  for (std::size_t first = 0; first < intervals.size() && !statistics.stopped;) {
    const StepGrid grid = stepGridAt(schedule, first, step);
    interval = *next;
    const int segment = interval.segment;
    const double begin = interval.begin;
    const int total = grid.steps * static_cast<int>(grid.count);
    int left = grid.steps;  // of this interval
    for (int done = 0; done < total && !statistics.stopped;) {
      const int block_end = std::min(done + kStepsPerBlock, total);
      const double* row = feed(segment, begin, grid.h, done, block_end);
      while (done < block_end && !statistics.stopped) {
        for (const int pause = std::min(block_end, done + left); done < pause; ++done, --left, row += 2 * width) {
          stepper.step(grid.h, row, row + width, row + 2 * width, x.data());
          ++statistics.steps;
        }
        requireFinite(Stepper::kName, begin + done * grid.h, x);
        if (left > 0) continue;
        if (interval.sample >= 0) statistics.stopped = !observe(interval.sample, interval.next, interval.end, x);
        ++next;
        if (done < total) interval = *next;
        left = grid.steps;
      }
    }
    first += grid.count;
  }
  statistics.evaluations = Stepper::kEvaluations * statistics.steps;
  return statistics;
}

/// runFedSteps() fed by the input itself, block by block.
template <class Stepper>
Statistics runFixedStep(Stepper& stepper, const Input& input, const Schedule& schedule, FixedStep step,
                        std::span<const double> x0, const Observer& observe) {
  const int width = 2 * input.channels();
  std::vector<double> u((2 * static_cast<std::size_t>(kStepsPerBlock) + 1) * static_cast<std::size_t>(width));
  const auto feed = [&](int segment, double begin, double h, int first, int last) {
    const int rows = 2 * (last - first) + 1;
    input.sweep(segment, begin, 0.5 * h, 2 * first, rows, {u.data(), static_cast<std::size_t>(rows * width)});
    return u.data();
  };
  return runFedSteps(stepper, width, feed, schedule, step, x0, observe);
}

}  // namespace vehicle
