#pragma once

#include <span>

#include "libvehicle/system/schedule.h"
#include "libvehicle/system/system.h"

namespace vehicle {

/// Size of fixed steps: the largest that is not above `step` and divides an interval evenly, then cut `refine`
/// times. Doubling refine doubles the steps of every interval, which is what a convergence order is read from.
struct FixedStep {
  double step = 1e-3;  // [s] > 0
  int refine = 1;      // >= 1
};

/// Tolerances of an adaptive method: local error <= absolute + relative |x|, per state, in the r.m.s. norm.
struct Accuracy {
  double relative = 1e-10;
  double absolute = 1e-12;
  double max_step =
      0.0;  // [s]; 0: the interval between two breakpoints, or a quarter of the input's shortest period there
};

// Every run starts from x0 at the schedule's first sample, ends steps on the breakpoints and restarts there with the
// one-sided limits of the input.
// @throws std::runtime_error    on NaN, infinity or a step size at rounding level, with the time reached:
//                               "rk4: state 3 is no longer finite (...) at t = 0.35 s"
// @throws std::invalid_argument for a step, tolerance, x0 or input that does not fit, with value and rule

/// Classical Runge-Kutta of order 4.
Statistics runRk4(const System& system, const Input& input, const Schedule& schedule, FixedStep step,
                  std::span<const double> x0, const Observer& observe);

/// Dormand-Prince 5(4), adaptive, output samples from its dense output of order 4.
Statistics runDopri5(const System& system, const Input& input, const Schedule& schedule, Accuracy accuracy,
                     std::span<const double> x0, const Observer& observe);

/// Exact propagation of a linear system under the closed-form input: one matrix exponential of the balanced,
/// augmented system per distinct interval, oscillators seeded anew from sine and cosine.
/// @throws std::invalid_argument if system.linear() is empty
Statistics runExact(const System& system, const Input& input, const Schedule& schedule, std::span<const double> x0,
                    const Observer& observe);

}  // namespace vehicle
