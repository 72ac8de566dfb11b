#include "libvehicle/simulate/flat_by_type.h"

#include <array>
#include <utility>

#include "libvehicle/integrate/adaptive_steps.h"
#include "libvehicle/integrate/dopri5.h"
#include "libvehicle/integrate/failure.h"
#include "libvehicle/integrate/fixed_steps.h"
#include "libvehicle/integrate/rk4.h"
#include "libvehicle/partition/schemes/blocked_rk4.h"

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

/// Steps in the form's inner order, shows in the vehicle's.
/// @tparam Steps  FixedSteps or AdaptiveSteps of a Stepper over FlatRhs
template <class Steps, class Stepper>
class FlatSteps final : public Integrator {
 public:
  template <class Setting>
  FlatSteps(const FlatForm& form, const Input& input, Setting setting)
      : order_(Stepper::kName, form),
        input_(input.inOrder(form.wheelOrder())),
        steps_(Stepper(*form.rhs()), input_, setting) {}
  FlatSteps(const FlatSteps&) = delete;  // steps_ looks at input_
  FlatSteps& operator=(const FlatSteps&) = delete;

  void restart(const Interval& at, std::span<const double> x) override {
    steps_.restart(at, order_.inner(x));
    state_ = order_.outer(steps_.state());
  }
  void advance(const Interval& interval) override {
    steps_.advance(interval);
    state_ = order_.outer(steps_.state());
  }
  [[nodiscard]] std::span<const double> state() const override { return state_; }
  [[nodiscard]] Statistics statistics() const override { return steps_.statistics(); }
  Statistics run(const Schedule& schedule, std::span<const double> x0, const Observer& observe) override {
    const std::array<double, kStates> inner = order_.inner(x0);
    return steps_.run(schedule, inner, [&](int sample, int segment, double t, std::span<const double> x) {
      return observe(sample, segment, t, order_.outer(x));
    });
  }

 private:
  InnerOrder order_;
  Input input_;
  Steps steps_;
  std::array<double, kStates> state_{};
};

}  // namespace

const FlatForm* flatFormOf(const System& system) { return dynamic_cast<const FlatForm*>(&system); }

std::unique_ptr<Integrator> makeFlatRk4(const RunProblem& problem, FixedStep step) {
  const FlatForm* form = typedForm(problem.system);
  if (form == nullptr) {
    // Three times as fast on a train, whose state and stages would go through the cache four times a step.
    const bool is_long = problem.system.equations() != nullptr && problem.system.size() > FlatRhs::kStates;
    return is_long ? makeBlockedRk4(problem, step) : makeRk4(problem, step);
  }
  return std::make_unique<FlatSteps<FixedSteps<FlatRk4>, FlatRk4>>(*form, problem.input, step);
}

std::unique_ptr<Integrator> makeFlatDopri5(const RunProblem& problem, Accuracy accuracy) {
  const FlatForm* form = typedForm(problem.system);
  if (form == nullptr) return makeDopri5(problem, accuracy);
  return std::make_unique<FlatSteps<AdaptiveSteps<FlatDopri5>, FlatDopri5>>(*form, problem.input, accuracy);
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
