#pragma once

#include <memory>

#include "libvehicle/integrate/integrator.h"
#include "libvehicle/integrate/step_control.h"
#include "libvehicle/integrate/step_walk.h"
#include "libvehicle/system/run_problem.h"

namespace vehicle {

// The methods over any System. Each makes its integrator for the problem's system and input, or does the whole run.
// @throws std::runtime_error    on NaN, infinity or a step size at rounding level, with the time reached:
//                               "rk4: state 3 is no longer finite (...) at t = 0.35 s"
// @throws std::invalid_argument for a step, tolerance, x0 or input that does not fit, with value and rule

/// Classical Runge-Kutta of order 4.
[[nodiscard]] std::unique_ptr<Integrator> makeRk4(const RunProblem& problem, FixedStep step);
Statistics runRk4(const RunProblem& problem, FixedStep step, const Observer& observe);

/// Dormand-Prince 5(4), adaptive, output samples from its dense output of order 4.
[[nodiscard]] std::unique_ptr<Integrator> makeDopri5(const RunProblem& problem, Accuracy accuracy);
Statistics runDopri5(const RunProblem& problem, Accuracy accuracy, const Observer& observe);

/// Exact propagation of a linear system under the closed-form input: one matrix exponential of the balanced,
/// augmented system per distinct interval, oscillators seeded anew from sine and cosine.
/// @throws std::invalid_argument if system.linear() is empty
[[nodiscard]] std::unique_ptr<Integrator> makeExact(const RunProblem& problem);
Statistics runExact(const RunProblem& problem, const Observer& observe);

}  // namespace vehicle
