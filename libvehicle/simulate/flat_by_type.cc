#include "libvehicle/simulate/flat_by_type.h"

#include <array>

#include "libvehicle/integrate/adaptive_run.h"
#include "libvehicle/integrate/dopri5.h"
#include "libvehicle/integrate/failure.h"
#include "libvehicle/integrate/fixed_step_run.h"
#include "libvehicle/integrate/rk4.h"

namespace vehicle {

namespace {

// Runs in the form's inner order, shows in the vehicle's.
// @param run  callable as run(form, problem, observer), the latter two in inner order
template <class Run>
auto runInInnerOrder(const char* method, const RunProblem& problem, const Observer& observe, Run run) {
  const FlatForm& form = *flatFormOf(problem);
  checkStart(method, problem.x0, form.size());
  const std::array<int, 8>& order = form.stateOrder();
  std::array<double, 8> inner{};
  std::array<double, 8> outer{};
  for (std::size_t i = 0; i < inner.size(); ++i) inner[i] = problem.x0[static_cast<std::size_t>(order[i])];
  const Observer observeInVehicleOrder = [&](int sample, int segment, double t, std::span<const double> x) {
    for (std::size_t i = 0; i < outer.size(); ++i) outer[static_cast<std::size_t>(order[i])] = x[i];
    return observe(sample, segment, t, outer);
  };
  const Input input = problem.input.inOrder(form.wheelOrder());
  return run(*form.rhs(), RunProblem{form, input, problem.schedule, inner}, observeInVehicleOrder);
}

/// A printed variant has no right-hand side by type.
bool isByType(const RunProblem& problem) {
  const FlatForm* form = flatFormOf(problem);
  return form != nullptr && form->rhs() != nullptr;
}

}  // namespace

const FlatForm* flatFormOf(const RunProblem& problem) { return dynamic_cast<const FlatForm*>(&problem.system); }

Statistics runFlatRk4(const RunProblem& problem, FixedStep step, const Observer& observe) {
  if (!isByType(problem)) {
    return runRk4(problem.system, problem.input, problem.schedule, step, problem.x0, observe);
  }
  return runInInnerOrder("rk4", problem, observe,
                         [&](const FlatRhs& rhs, const RunProblem& inner, const Observer& show) {
                           Rk4<FlatRhs, FlatRhs::kStates> stepper(rhs);
                           return runFixedStep(stepper, inner.input, inner.schedule, step, inner.x0, show);
                         });
}

PipelineRun runFlatPipeline(const RunProblem& problem, FixedStep step, const Observer& observe, int threads,
                            const TeamPolicy& team) {
  if (!isByType(problem)) return runPipeline(problem, step, observe, threads, team);
  return runInInnerOrder("rk4", problem, observe,
                         [&](const FlatRhs& rhs, const RunProblem& inner, const Observer& show) {
                           Rk4<FlatRhs, FlatRhs::kStates> stepper(rhs);
                           return runPipelined(stepper, inner, {step, sweepRows(inner.input), threads}, show, team);
                         });
}

Statistics runFlatDopri5(const RunProblem& problem, Accuracy accuracy, const Observer& observe) {
  if (!isByType(problem)) {
    return runDopri5(problem.system, problem.input, problem.schedule, accuracy, problem.x0, observe);
  }
  return runInInnerOrder("dopri5", problem, observe,
                         [&](const FlatRhs& rhs, const RunProblem& inner, const Observer& show) {
                           Dopri5<FlatRhs, FlatRhs::kStates> stepper(rhs);
                           return runAdaptive(stepper, inner.input, inner.schedule, accuracy, inner.x0, show);
                         });
}

}  // namespace vehicle
