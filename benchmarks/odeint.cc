// Boost.odeint on the paper's case: the same equations (FlatRhs), the rail with one sine and cosine an evaluation.

#include <boost/numeric/odeint.hpp>

#include "benchmarks/measure.h"

namespace vehicle::bench {
namespace {

namespace odeint = boost::numeric::odeint;

State solveRk4Odeint(const PaperCase& problem) {
  const TimedEquations equations{*problem.form->rhs(), {}};
  odeint::runge_kutta4<State> stepper;
  State x{};
  odeint::integrate_n_steps(stepper, std::cref(equations), x, 0.0, kStep, kSteps);
  return x;
}

State solveDopri5Odeint(const PaperCase& problem) {
  const TimedEquations equations{*problem.form->rhs(), {}};
  // The loosest tolerances, by powers of ten, that reach the error of the comparison.
  auto stepper = odeint::make_controlled<odeint::runge_kutta_dopri5<State>>(1e-12, 1e-9);
  State x{};
  odeint::integrate_adaptive(stepper, std::cref(equations), x, 0.0, 10.0, kStep);
  return x;
}

const bool kRegistered = [] {
  const auto add = [](const char* name, double error, long steps, State (*solve)(const PaperCase&)) {
    compare(name, [=](benchmark::State& state) {
      measure(state, paperCase(), error, steps, [&] { return solve(paperCase()); });
    });
  };
  add("step_1ms/ours_rk4", kRk4Error, kSteps, solveRk4);
  add("step_1ms/ours_rk4_virtual", kRk4Error, kSteps, solveRk4Virtual);
  add("step_1ms/ours_rk4_same_rail", kRk4Error, kSteps, solveRk4OneSincos);
  add("step_1ms/ours_exact", kRk4Error, kSteps, solveExact);
  add("step_1ms/odeint_rk4", kRk4Error, kSteps, solveRk4Odeint);
  add("run_10s_error_1e-8/ours_dopri5", kAdaptiveError, 1, solveDopri5);
  add("run_10s_error_1e-8/ours_exact", kAdaptiveError, 1, solveExact);
  add("run_10s_error_1e-8/odeint_dopri5", kAdaptiveError, 1, solveDopri5Odeint);
  return true;
}();

}  // namespace
}  // namespace vehicle::bench
