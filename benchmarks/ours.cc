#include <algorithm>

#include "benchmarks/measure.h"
#include "libvehicle/integrate/adaptive_steps.h"
#include "libvehicle/integrate/dopri5.h"
#include "libvehicle/integrate/fixed_steps.h"
#include "libvehicle/integrate/rk4.h"
#include "libvehicle/integrate/run.h"

namespace vehicle::bench {

namespace {

const State kRest{};

// Keeps the last state and nothing else.
struct Last {
  State state{};
  bool operator()(int, int, double, std::span<const double> x) {
    std::copy(x.begin(), x.end(), state.begin());
    return true;
  }
};

template <class Run>
State lastOf(Run run) {
  Last last;
  run(Observer(std::ref(last)));
  return last.state;
}

}  // namespace

State solveRk4(const PaperCase& problem) {
  return lastOf([&](const Observer& observe) {
    Rk4<FlatRhs, kStates> stepper(*problem.form->rhs());
    FixedSteps(stepper, problem.input, {kStep}).run(problem.whole, kRest, observe);
  });
}

State solveRk4Virtual(const PaperCase& problem) {
  return lastOf([&](const Observer& observe) {
    runRk4({*problem.form, problem.input, problem.whole, kRest}, {kStep}, observe);
  });
}

State solveRk4OneSincos(const PaperCase& problem) {
  Rk4<FlatRhs, kStates> stepper(*problem.form->rhs());
  static const OneSincosRail rail;
  State x{};
  std::array<double, 8> begin{}, middle{}, end{};
  rail(0.0, end.data());
  for (long i = 0; i < kSteps; ++i) {
    const double t = static_cast<double>(i) * kStep;
    begin = end;  // the step before ended where this one begins
    rail(t + 0.5 * kStep, middle.data());
    rail(t + kStep, end.data());
    stepper.step(kStep, begin.data(), middle.data(), end.data(), x.data());
  }
  return x;
}

State solveExact(const PaperCase& problem) {
  return lastOf([&](const Observer& observe) {
    runExact({*problem.form, problem.input, problem.every_step, kRest}, observe);
  });
}

State solveDopri5(const PaperCase& problem) {
  return lastOf([&](const Observer& observe) {
    Dopri5<FlatRhs, kStates> stepper(*problem.form->rhs());
    AdaptiveSteps(stepper, problem.input, {.relative = 1e-9, .absolute = 1e-12}).run(problem.whole, kRest, observe);
  });
}

}  // namespace vehicle::bench
