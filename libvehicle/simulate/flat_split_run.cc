#include "libvehicle/simulate/flat_split_run.h"

#include <algorithm>
#include <array>

#include "libvehicle/flat/flat_split.h"
#include "libvehicle/integrate/failure.h"
#include "libvehicle/integrate/fixed_step_run.h"
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

/// The start in halves, the way back for the observer, the input of each half.
class SplitRun {
 public:
  SplitRun(const char* method, const RunProblem& problem, const Observer& observe)
      : split_(*flatFormOf(problem)),
        schedule_(problem.schedule),
        observe_(observe),
        both_(mixed(method, problem.input, split_.mixing())) {
    checkStart(method, problem.x0, problem.system.size());
    split_.toHalves(problem.x0, start_);
  }

  [[nodiscard]] const FlatSplit& split() const { return split_; }
  [[nodiscard]] const Input& bothInputs() const { return both_; }  // two channels: bounce, pitch
  [[nodiscard]] std::span<const double> start() const { return start_; }
  [[nodiscard]] Observer observer() {
    return [this](int sample, int segment, double t, std::span<const double> halves) {
      split_.fromHalves(halves, shown_);
      return observe_(sample, segment, t, shown_);
    };
  }

  /// @param run  callable as run(half, problem of the half, observer, member)
  template <class Run>
  PartsRun runApart(int threads, const TeamPolicy& team, Run run) {
    const std::array<Input, 2> inputs = {mixedInput(both_, std::array{1.0, 0.0}),
                                         mixedInput(both_, std::array{0.0, 1.0})};
    const auto part = [&](const FlatHalf& half, std::size_t number) {
      return IndependentPart{FlatHalfRhs::kStates, [&, number](const Observer& show, Member* me) {
                               const RunProblem own{half, inputs[number], schedule_, start().subspan(4 * number, 4)};
                               return run(half, own, show, me);
                             }};
    };
    return runIndependentParts({part(split_.bounce(), 0), part(split_.pitch(), 1)}, schedule_.samples(), observer(),
                               threads, team);
  }

 private:
  static Input mixed(const char* method, const Input& input, const std::array<double, 8>& mixing) {
    checkChannels(method, 4, input.channels());
    return mixedInput(input, mixing);
  }

  FlatSplit split_;
  const Schedule& schedule_;
  const Observer& observe_;
  Input both_;
  std::array<double, 8> start_{};  // bounce, pitch
  std::array<double, 8> shown_{};  // in the vehicle's order
};

}  // namespace

PartsRun runFlatRk4Split(const RunProblem& problem, FixedStep step, const Observer& observe, int threads,
                         const TeamPolicy& team) {
  SplitRun run("rk4_split", problem, observe);
  if (threads == 1) {
    Rk4<BothHalvesRhs, 8> stepper(BothHalvesRhs(run.split()));
    PartsRun alone;
    alone.statistics = runFixedStep(stepper, run.bothInputs(), problem.schedule, step, run.start(), run.observer());
    alone.statistics.evaluations *= 2;  // of two systems, as on two threads
    return alone;
  }
  return run.runApart(threads, team,
                      [&](const FlatHalf& half, const RunProblem& own, const Observer& show, Member* me) {
                        Rk4<FlatHalfRhs, FlatHalfRhs::kStates> stepper(half.rhs());
                        if (me == nullptr || team.tracer == nullptr) {
                          return runFixedStep(stepper, own.input, own.schedule, step, own.x0, show);
                        }
                        TracedStepper<Rk4<FlatHalfRhs, FlatHalfRhs::kStates>> traced{stepper, *me};
                        return runFixedStep(traced, own.input, own.schedule, step, own.x0, show);
                      });
}

}  // namespace vehicle
