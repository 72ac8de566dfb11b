#include "libvehicle/simulate/flat_split_run.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/format.h>

#include "libvehicle/flat/flat_split.h"
#include "libvehicle/flat/flat_train.h"
#include "libvehicle/integrate/failure.h"
#include "libvehicle/integrate/fixed_steps.h"
#include "libvehicle/integrate/rk4.h"
#include "libvehicle/partition/schemes/pipeline.h"
#include "libvehicle/simulate/flat_by_type.h"
#include "libvehicle/system/mixed_input.h"

namespace vehicle {

namespace {

/// Both halves side by side, for one thread: u = (eta_s, eta_d, eta_s', eta_d'). Every number is computed as in the
/// half alone, in the same order.
class BothHalvesRhs {
 public:
  explicit BothHalvesRhs(const FlatSplit& split) : bounce_(split.bounce().rhs()), pitch_(split.pitch().rhs()) {}
  void operator()(const double* x, const double* u, double* dx) const {
    const std::array<double, 4> input = {u[0], u[2], u[1], u[3]};
    std::array<double, 8> slope;  // not dx itself: it might overlap the coefficients for all the compiler knows
    bounce_(x, input.data(), slope.data());
    pitch_(x + 4, input.data() + 2, slope.data() + 4);
    std::copy(slope.begin(), slope.end(), dx);
  }

 private:
  FlatHalfRhs bounce_;
  FlatHalfRhs pitch_;
};

constexpr const char* kName = "rk4_split";

FlatSplit splitOf(const System& system) {
  if (const std::string why = splitUnsupportedBy(system); !why.empty()) throw std::invalid_argument(why);
  return FlatSplit(*flatFormOf(system));
}

/// @return two channels: bounce, pitch
Input mixed(const Input& input, const FlatSplit& split) {
  checkChannels(kName, 4, input.channels());
  return mixedInput(input, split.mixing());
}

/// Both halves in one loop, shown in the vehicle's order.
class SplitSteps final : public Integrator {
 public:
  SplitSteps(const RunProblem& problem, FixedStep step)
      : split_(splitOf(problem.system)),
        input_(mixed(problem.input, split_)),
        steps_(Rk4<BothHalvesRhs, kStates>(BothHalvesRhs(split_)), input_, step) {}
  SplitSteps(const SplitSteps&) = delete;  // steps_ looks at input_
  SplitSteps& operator=(const SplitSteps&) = delete;

  void restart(const Interval& at, std::span<const double> x) override {
    checkStart(kName, x, kStates);
    std::array<double, kStates> halves{};
    split_.toHalves(x, halves);
    steps_.restart(at, halves);
    split_.fromHalves(steps_.state(), state_);
  }
  void advance(const Interval& interval) override {
    steps_.advance(interval);
    split_.fromHalves(steps_.state(), state_);
  }
  [[nodiscard]] std::span<const double> state() const override { return state_; }
  [[nodiscard]] Statistics statistics() const override {
    Statistics statistics = steps_.statistics();
    statistics.evaluations *= kHalves;
    return statistics;
  }
  Statistics run(const Schedule& schedule, std::span<const double> x0, const Observer& observe) override {
    checkStart(kName, x0, kStates);
    std::array<double, kStates> halves{};
    split_.toHalves(x0, halves);
    Statistics whole = steps_.run(schedule, halves, [&](int sample, int segment, double t, std::span<const double> x) {
      split_.fromHalves(x, state_);
      return observe(sample, segment, t, state_);
    });
    whole.evaluations *= kHalves;
    return whole;
  }

 private:
  static constexpr int kHalves = 2;  // two systems, as on two threads
  static constexpr int kStates = kHalves * FlatHalfRhs::kStates;
  FlatSplit split_;
  Input input_;
  FixedSteps<Rk4<BothHalvesRhs, kStates>> steps_;
  std::array<double, kStates> state_{};
};

}  // namespace

std::string splitUnsupportedBy(const System& system) {
  if (dynamic_cast<const FlatTrain*>(&system) != nullptr) {
    return "rk4_split: couplings join the bounce and pitch of a train's vehicles; take rk4";
  }
  const FlatForm* flat = flatFormOf(system);
  if (flat == nullptr) return "rk4_split: the form is not the flat one";
  const std::string unsupported = splitUnsupported(*flat);
  return unsupported.empty() ? unsupported : fmt::format("rk4_split: {}; take rk4", unsupported);
}

std::unique_ptr<Integrator> makeFlatRk4Split(const RunProblem& problem, FixedStep step) {
  return std::make_unique<SplitSteps>(problem, step);
}

PartsRun runFlatRk4Split(const RunProblem& problem, FixedStep step, const Observer& observe, int threads,
                         const TeamPolicy& team) {
  if (threads == 1) {
    return {.statistics = makeFlatRk4Split(problem, step)->run(problem.schedule, problem.x0, observe), .team = {}};
  }
  const FlatSplit split = splitOf(problem.system);
  const Input both = mixed(problem.input, split);
  const std::array<Input, 2> inputs = {mixedInput(both, std::array{1.0, 0.0}), mixedInput(both, std::array{0.0, 1.0})};
  checkStart(kName, problem.x0, problem.system.size());
  std::array<double, 8> start{};  // bounce, pitch
  split.toHalves(problem.x0, start);
  std::array<double, 8> shown{};  // in the vehicle's order
  const Observer showWhole = [&](int sample, int segment, double t, std::span<const double> halves) {
    split.fromHalves(halves, shown);
    return observe(sample, segment, t, shown);
  };
  const auto part = [&](const FlatHalf& half, std::size_t number) {
    return IndependentPart{FlatHalfRhs::kStates, [&, number](const Observer& show, Member* me) {
                             const auto run = [&](const auto& stepper) {
                               FixedSteps steps(stepper, inputs[number], step);
                               return steps.run(problem.schedule, std::span(start).subspan(4 * number, 4), show);
                             };
                             using Stepper = Rk4<FlatHalfRhs, FlatHalfRhs::kStates>;
                             const Stepper stepper(half.rhs());
                             if (me == nullptr || team.tracer == nullptr) return run(stepper);
                             return run(TracedStepper<Stepper>{stepper, *me});
                           }};
  };
  return runIndependentParts({part(split.bounce(), 0), part(split.pitch(), 1)}, problem.schedule.samples(), showWhole,
                             threads, team);
}

}  // namespace vehicle
