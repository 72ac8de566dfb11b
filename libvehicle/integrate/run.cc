#include "libvehicle/integrate/run.h"

#include "libvehicle/integrate/adaptive_steps.h"
#include "libvehicle/integrate/dopri5.h"
#include "libvehicle/integrate/exact_steps.h"
#include "libvehicle/integrate/fixed_steps.h"
#include "libvehicle/integrate/rk4.h"
#include "libvehicle/integrate/system_rhs.h"

namespace vehicle {
namespace {

Statistics runBy(Integrator& method, const RunProblem& problem, const Observer& observe) {
  return method.run(problem.schedule, problem.x0, observe);
}

}  // namespace

std::unique_ptr<Integrator> makeRk4(const RunProblem& problem, FixedStep step) {
  using Stepper = Rk4<SystemRhs>;
  checkChannels(Stepper::kName, problem.system.channels(), problem.input.channels());
  return std::make_unique<FixedSteps<Stepper>>(Stepper(SystemRhs(problem.system), problem.system.size()), problem.input,
                                               step);
}

std::unique_ptr<Integrator> makeDopri5(const RunProblem& problem, Accuracy accuracy) {
  using Stepper = Dopri5<SystemRhs>;
  checkChannels(Stepper::kName, problem.system.channels(), problem.input.channels());
  return std::make_unique<AdaptiveSteps<Stepper>>(Stepper(SystemRhs(problem.system), problem.system.size()),
                                                  problem.input, accuracy);
}

std::unique_ptr<Integrator> makeExact(const RunProblem& problem) {
  return std::make_unique<ExactSteps>(problem.system, problem.input);
}

Statistics runRk4(const RunProblem& problem, FixedStep step, const Observer& observe) {
  return runBy(*makeRk4(problem, step), problem, observe);
}

Statistics runDopri5(const RunProblem& problem, Accuracy accuracy, const Observer& observe) {
  return runBy(*makeDopri5(problem, accuracy), problem, observe);
}

Statistics runExact(const RunProblem& problem, const Observer& observe) {
  return runBy(*makeExact(problem), problem, observe);
}

}  // namespace vehicle
