#include "libvehicle/partition/run.h"

#include <numeric>
#include <stdexcept>
#include <string>

#include "libvehicle/partition/schemes/exact_rows.h"
#include "libvehicle/partition/schemes/halo_exchange.h"
#include "libvehicle/partition/schemes/pipeline.h"
#include "libvehicle/partition/schemes/stage_exchange.h"

namespace vehicle {

PartitionRun runPartitioned(const System& system, const Input& input, const Schedule& schedule, FixedStep step,
                            std::span<const double> x0, const Observer& observe, const PartitionChoice& choice) {
  switch (choice.scheme) {
    case Scheme::kSerial: {
      if (choice.team.threads != 1) {
        throw std::invalid_argument("scheme serial is for 1 thread, here are " + std::to_string(choice.team.threads) +
                                    "; take stages, halo, rows or pipeline");
      }
      PartitionChoice alone = choice;
      alone.map = EquationMap::kAuto;
      return runHaloExchange(system, input, schedule, step, x0, observe, alone);
    }
    case Scheme::kStages:
      return runStageExchange(system, input, schedule, step, x0, observe, choice);
    case Scheme::kHalo:
      return runHaloExchange(system, input, schedule, step, x0, observe, choice);
    case Scheme::kRows:
      return runExactRows(system, input, schedule, x0, observe, choice);
    case Scheme::kPipeline:
      return runPipeline(system, input, schedule, step, x0, observe, choice.team).run;
    case Scheme::kSplit:
      break;
  }
  throw std::invalid_argument("scheme split needs a symmetric vehicle of the flat form and has an entry of its own");
}

}  // namespace vehicle
