#include "libvehicle/partition/schemes/pipeline.h"

#include "libvehicle/integrate/rk4.h"
#include "libvehicle/integrate/system_rhs.h"

namespace vehicle {

BlockRows sweepRows(const Input& input) {
  return [&input](const StepBlock& block, int rows, double* u) {
    const auto values = static_cast<std::size_t>(rows) * 2 * static_cast<std::size_t>(input.channels());
    input.sweep(block.segment, block.begin, 0.5 * block.h, 2 * block.first, rows, {u, values});
  };
}

BlockRows evaluatedRows(const Input& input) {
  return [&input](const StepBlock& block, int rows, double* u) {
    const std::size_t width = 2 * static_cast<std::size_t>(input.channels());
    for (int i = 0; i < rows; ++i, u += width) {
      input.evaluate(block.segment, block.begin + 0.5 * block.h * (2 * block.first + i), {u, width});
    }
  };
}

PipelineRun runPipeline(const System& system, const Input& input, const Schedule& schedule, FixedStep step,
                        std::span<const double> x0, const Observer& observe, const TeamChoice& team) {
  checkChannels("rk4", system.channels(), input.channels());
  Rk4<SystemRhs> stepper(SystemRhs(system), system.size());
  return runPipelined(stepper, input.channels(), sweepRows(input), schedule, step, x0, observe, team);
}

}  // namespace vehicle
