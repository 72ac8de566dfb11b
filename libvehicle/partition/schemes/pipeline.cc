#include "libvehicle/partition/schemes/pipeline.h"

#include <algorithm>

#include "libvehicle/integrate/rk4.h"
#include "libvehicle/integrate/system_rhs.h"

namespace vehicle {

BlockRows sweepRows(const Input& input) {
  return [&input](const StepBlock& block, int rows, double* u) {
    const auto values = static_cast<std::size_t>(rows) * 2 * static_cast<std::size_t>(input.channels());
    input.sweep(block.segment, block.begin, 0.5 * block.h, 2 * block.first, rows, {u, values});
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
