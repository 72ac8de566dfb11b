#include "libvehicle/simulate/shared_run.h"

#include <stdexcept>

#include "libvehicle/simulate/flat_split_run.h"
#include "libvehicle/simulate/thread_choice.h"

namespace vehicle {

SharedRun runShared(const std::string& method, const System& system, const Input& input, const Schedule& schedule,
                    const MethodSettings& settings, std::span<const double> x0, const Observer& observe,
                    const ThreadRequest& request) {
  SharedRun run;
  if (isSplitMethod(method) && request.threads == 2) {
    if (const std::string misfit = splitMethodMisfit(method, system); !misfit.empty()) {
      throw std::invalid_argument(misfit);
    }
    const auto& flat = dynamic_cast<const FlatForm&>(system);
    {
      TeamChoice team = request.team;
      team.threads = 2;
      PartsRun parts = method == "exact_split"
                           ? runFlatExactSplit(flat, input, schedule, x0, observe, team)
                           : runFlatRk4Split(flat, input, schedule, settings.step, x0, observe, team);
      return {parts.statistics, Scheme::kSplit, 2, std::move(parts.team), {}};
    }
  }
  run.statistics = runMethod(method, system, input, schedule, settings, x0, observe);
  return run;
}

}  // namespace vehicle
