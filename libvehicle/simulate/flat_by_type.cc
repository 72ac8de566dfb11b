#include "libvehicle/simulate/flat_by_type.h"

#include <array>

#include "libvehicle/integrate/adaptive_steps.h"
#include "libvehicle/integrate/dopri5.h"
#include "libvehicle/integrate/failure.h"
#include "libvehicle/integrate/fixed_steps.h"
#include "libvehicle/integrate/rk4.h"
#include "libvehicle/partition/schemes/blocked_rk4.h"
#include "libvehicle/simulate/mapped_steps.h"

namespace vehicle {

namespace {

constexpr std::size_t kStates = FlatRhs::kStates;
using FlatRk4 = Rk4<FlatRhs, FlatRhs::kStates>;
using FlatDopri5 = Dopri5<FlatRhs, FlatRhs::kStates>;

/// The form with a right-hand side by type, else nullptr: a printed variant has none.
const FlatForm* typedForm(const System& system) {
  const FlatForm* form = flatFormOf(system);
  return form != nullptr && form->rhs() != nullptr ? form : nullptr;
}

/// A state between the form's inner order and the vehicle's.
class InnerOrder {
 public:
  static constexpr int kSystems = 1;
  InnerOrder(const char* method, const FlatForm& form) : method_(method), order_(form.stateOrder()) {}
  const std::array<double, kStates>& inner(std::span<const double> x) {
    checkStart(method_, x, FlatRhs::kStates);
    for (std::size_t i = 0; i < kStates; ++i) inner_[i] = x[static_cast<std::size_t>(order_[i])];
    return inner_;
  }
  const std::array<double, kStates>& outer(std::span<const double> x) {
    for (std::size_t i = 0; i < kStates; ++i) outer_[static_cast<std::size_t>(order_[i])] = x[i];
    return outer_;
  }

 private:
  const char* method_;
  std::array<int, kStates> order_;
  std::array<double, kStates> inner_{};
  std::array<double, kStates> outer_{};
};

/// Steps in the form's inner order, shown in the vehicle's.
/// @tparam Steps  FixedSteps or AdaptiveSteps of a Stepper over FlatRhs
template <class Stepper, class Steps, class Setting>
std::unique_ptr<Integrator> stepsInInnerOrder(const FlatForm& form, const Input& input, Setting setting) {
  return std::make_unique<MappedSteps<InnerOrder, Steps>>(
      InnerOrder(Stepper::kName, form), input.inOrder(form.wheelOrder()),
      [&](const InnerOrder&, const Input& inner) { return Steps(Stepper(*form.rhs()), inner, setting); });
}

}  // namespace

const FlatForm* flatFormOf(const System& system) { return dynamic_cast<const FlatForm*>(&system); }

std::unique_ptr<Integrator> makeFlatRk4(const RunProblem& problem, FixedStep step) {
  const FlatForm* form = typedForm(problem.system);
  if (form == nullptr) {
    // Three times as fast on a train, whose state and stages would go through the cache four times a step.
    const bool is_long = problem.system.equations() != nullptr && problem.system.size() > FlatRhs::kStates;
    return is_long ? makeBlockedRk4(problem, step) : makeRk4(problem, step);
  }
  return stepsInInnerOrder<FlatRk4, FixedSteps<FlatRk4>>(*form, problem.input, step);
}

std::unique_ptr<Integrator> makeFlatDopri5(const RunProblem& problem, Accuracy accuracy) {
  const FlatForm* form = typedForm(problem.system);
  if (form == nullptr) return makeDopri5(problem, accuracy);
  return stepsInInnerOrder<FlatDopri5, AdaptiveSteps<FlatDopri5>>(*form, problem.input, accuracy);
}

PipelineRun runFlatPipeline(const RunProblem& problem, FixedStep step, const Observer& observe, int threads,
                            const TeamPolicy& team) {
  const FlatForm* form = typedForm(problem.system);
  if (form == nullptr) return runPipeline(problem, step, observe, threads, team);
  InnerOrder order(FlatRk4::kName, *form);
  const std::array<double, kStates> x0 = order.inner(problem.x0);
  const Input input = problem.input.inOrder(form->wheelOrder());
  const Observer observeInVehicleOrder = [&](int sample, int segment, double t, std::span<const double> x) {
    return observe(sample, segment, t, order.outer(x));
  };
  return runPipelined(FlatRk4(*form->rhs()), {*form, input, problem.schedule, x0}, {step, sweepRows(input), threads},
                      observeInVehicleOrder, team);
}

}  // namespace vehicle
