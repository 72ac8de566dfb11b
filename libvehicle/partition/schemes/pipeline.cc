#include "libvehicle/partition/schemes/pipeline.h"

#include <algorithm>

#include "libvehicle/integrate/rk4.h"
#include "libvehicle/integrate/system_rhs.h"

namespace vehicle {

BlockRows sweepRows(const Input& input) {
  return [&input](const StepBlock& block, double* u) {
    block.sweep(input, {u, static_cast<std::size_t>(block.rows()) * 2 * static_cast<std::size_t>(input.channels())});
  };
}

PipelineRun runPipeline(const RunProblem& problem, FixedStep step, const Observer& observe, int threads,
                        const TeamPolicy& team) {
  checkChannels("rk4", problem.system.channels(), problem.input.channels());
  Rk4<SystemRhs> stepper(SystemRhs(problem.system), problem.system.size());
  return runPipelined(stepper, problem, {step, sweepRows(problem.input), threads}, observe, team);
}

double pipelineStep(const StepCosts& costs, int threads) {
  return std::max(costs.step / threads, costs.step - costs.input);
}

}  // namespace vehicle
