#include "libvehicle/simulate/flat_by_type.h"

#include <array>

#include "libvehicle/integrate/adaptive_run.h"
#include "libvehicle/integrate/dopri5.h"
#include "libvehicle/integrate/failure.h"
#include "libvehicle/integrate/fixed_step_run.h"
#include "libvehicle/integrate/rk4.h"
#include "libvehicle/partition/schemes/stage_by_type.h"

namespace vehicle {

namespace {

// Runs in the form's inner order, shows in the vehicle's.
// @param run  callable as run(input, x0, observer), all in inner order
template <class Run>
auto runInInnerOrder(const FlatForm& form, const Input& input, std::span<const double> x0,
                           const Observer& observe, Run run) {
  const std::array<int, 8>& order = form.stateOrder();
  std::array<double, 8> inner{};
  std::array<double, 8> outer{};
  for (std::size_t i = 0; i < inner.size(); ++i) inner[i] = x0[static_cast<std::size_t>(order[i])];
  const Observer observeInVehicleOrder = [&](int sample, int segment, double t, std::span<const double> x) {
    for (std::size_t i = 0; i < outer.size(); ++i) outer[static_cast<std::size_t>(order[i])] = x[i];
    return observe(sample, segment, t, outer);
  };
  return run(input.inOrder(form.wheelOrder()), inner, observeInVehicleOrder);
}

}  // namespace

Statistics runFlatRk4(const FlatForm& form, const Input& input, const Schedule& schedule, FixedStep step,
                      std::span<const double> x0, const Observer& observe) {
  if (form.rhs() == nullptr) return runRk4(form, input, schedule, step, x0, observe);
  checkStart("rk4", x0, form.size());
  return runInInnerOrder(form, input, x0, observe, [&](const Input& u, std::span<const double> x,
                                                       const Observer& show) {
    Rk4<FlatRhs, FlatRhs::kStates> stepper(*form.rhs());
    return runFixedStep(stepper, u, schedule, step, x, show);
  });
}

PipelineRun runFlatPipeline(const FlatForm& form, const Input& input, const Schedule& schedule, FixedStep step,
                            std::span<const double> x0, const Observer& observe, const TeamChoice& team) {
  if (form.rhs() == nullptr) return runPipeline(form, input, schedule, step, x0, observe, team);
  checkStart("rk4", x0, form.size());
  return runInInnerOrder(form, input, x0, observe, [&](const Input& u, std::span<const double> x,
                                                       const Observer& show) {
    Rk4<FlatRhs, FlatRhs::kStates> stepper(*form.rhs());
    return runPipelined(stepper, u.channels(), sweepRows(u), schedule, step, x, show, team);
  });
}

PartitionRun runFlatStages(const FlatForm& form, const Input& input, const Schedule& schedule, FixedStep step,
                           std::span<const double> x0, const Observer& observe, const PartitionChoice& choice) {
  // A printed variant is refused there: it cannot be cut.
  if (form.rhs() == nullptr) return runPartitioned(form, input, schedule, step, x0, observe, choice);
  return runStageExchangeByType(*form.rhs(), form, input, schedule, step, x0, observe, choice);
}

Statistics runFlatDopri5(const FlatForm& form, const Input& input, const Schedule& schedule, Accuracy accuracy,
                         std::span<const double> x0, const Observer& observe) {
  if (form.rhs() == nullptr) return runDopri5(form, input, schedule, accuracy, x0, observe);
  checkStart("dopri5", x0, form.size());
  return runInInnerOrder(form, input, x0, observe, [&](const Input& u, std::span<const double> x,
                                                       const Observer& show) {
    Dopri5<FlatRhs, FlatRhs::kStates> stepper(*form.rhs());
    return runAdaptive(stepper, u, schedule, accuracy, x, show);
  });
}

}  // namespace vehicle
