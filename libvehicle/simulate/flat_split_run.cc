#include "libvehicle/simulate/flat_split_run.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/flat/flat_split.h"
#include "libvehicle/flat/flat_train.h"
#include "libvehicle/integrate/failure.h"
#include "libvehicle/integrate/fixed_steps.h"
#include "libvehicle/integrate/rk4.h"
#include "libvehicle/partition/schemes/pipeline.h"
#include "libvehicle/simulate/flat_by_type.h"
#include "libvehicle/simulate/mapped_steps.h"
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

/// The input of both halves: two channels, bounce and pitch.
Input mixed(const Input& input, const FlatSplit& split) {
  checkChannels(kName, 4, input.channels());
  return mixedInput(input, split.mixing());
}

/// A state between bounce and pitch, one after the other, and the vehicle's order.
class Halves {
 public:
  static constexpr int kSystems = 2;
  static constexpr int kStates = kSystems * FlatHalfRhs::kStates;

  explicit Halves(FlatSplit split) : split_(std::move(split)) {}
  [[nodiscard]] const FlatSplit& split() const { return split_; }
  const std::array<double, kStates>& inner(std::span<const double> x) {
    checkStart(kName, x, kStates);
    split_.toHalves(x, inner_);
    return inner_;
  }
  const std::array<double, kStates>& outer(std::span<const double> halves) {
    split_.fromHalves(halves, outer_);
    return outer_;
  }

 private:
  FlatSplit split_;
  std::array<double, kStates> inner_{};
  std::array<double, kStates> outer_{};
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
  using Stepper = Rk4<BothHalvesRhs, Halves::kStates>;
  FlatSplit split = splitOf(problem.system);
  Input both = mixed(problem.input, split);
  return std::make_unique<MappedSteps<Halves, FixedSteps<Stepper>>>(
      Halves(std::move(split)), std::move(both), [&](const Halves& halves, const Input& input) {
        return FixedSteps<Stepper>(Stepper(BothHalvesRhs(halves.split())), input, step);
      });
}

PartsRun runFlatRk4Split(const RunProblem& problem, FixedStep step, const Observer& observe, int threads,
                         const TeamPolicy& team) {
  if (threads == 1) {
    return {.statistics = makeFlatRk4Split(problem, step)->run(problem.schedule, problem.x0, observe), .team = {}};
  }
  Halves halves(splitOf(problem.system));
  const FlatSplit& split = halves.split();
  const Input both = mixed(problem.input, split);
  const std::array<Input, 2> inputs = {mixedInput(both, std::array{1.0, 0.0}), mixedInput(both, std::array{0.0, 1.0})};
  const std::span<const double> start = halves.inner(problem.x0);
  const Observer showWhole = [&](int sample, int segment, double t, std::span<const double> x) {
    return observe(sample, segment, t, halves.outer(x));
  };
  const auto part = [&](const FlatHalf& half, std::size_t number) {
    return IndependentPart{FlatHalfRhs::kStates, [&, number](const Observer& show, Member* me) {
                             const auto run = [&](const auto& stepper) {
                               FixedSteps steps(stepper, inputs[number], step);
                               return steps.run(problem.schedule, start.subspan(4 * number, 4), show);
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
