#include "libvehicle/partition/run.h"

#include <stdexcept>
#include <string>

#include "libvehicle/partition/schemes/halo_exchange.h"
#include "libvehicle/partition/schemes/pipeline.h"
#include "libvehicle/partition/schemes/stage_exchange.h"

namespace vehicle {

PartitionRun runPartitioned(const RunProblem& problem, FixedStep step, const Observer& observe, const Sharing& sharing,
                            const TeamPolicy& team) {
  switch (sharing.scheme.value_or(Scheme::kSerial)) {
    case Scheme::kSerial:
      if (sharing.threads != 1) {
        throw std::invalid_argument("scheme serial is for 1 thread, here are " + std::to_string(sharing.threads) +
                                    "; take stages, halo or pipeline");
      }
      return runHaloExchange(problem, step, observe, {.threads = 1}, team);
    case Scheme::kStages:
      return runStageExchange(problem, step, observe, sharing, team);
    case Scheme::kHalo:
      return runHaloExchange(problem, step, observe, sharing, team);
    case Scheme::kPipeline:
      return runPipeline(problem, step, observe, sharing.threads, team).run;
    case Scheme::kSplit:
      break;
  }
  throw std::invalid_argument("scheme split needs a symmetric vehicle of the flat form and has an entry of its own");
}

double bestStep(const StepCosts& costs, const EquationSet* set, const Sharing& sharing) {
  switch (sharing.scheme.value_or(Scheme::kSerial)) {
    case Scheme::kSerial:
      return costs.step;
    case Scheme::kStages:
      return stageExchangeStep(costs, *set, sharing);
    case Scheme::kHalo:
      return haloExchangeStep(costs, *set, sharing);
    case Scheme::kPipeline:
      return pipelineStep(costs, sharing.threads);
    case Scheme::kSplit:
      return costs.step / sharing.threads;
  }
  return costs.step;
}

}  // namespace vehicle
