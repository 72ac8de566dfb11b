#include "libvehicle/model/compiled_model.h"

#include <utility>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/model/laws.h"

namespace vehicle {

CompiledModel compile(Vehicle vehicle, double gravity) {
  if (ProblemList problems = check(vehicle); !problems.empty()) throw InvalidInput(std::move(problems));
  return compileChecked(std::move(vehicle), gravity);
}

CompiledModel compileChecked(Vehicle vehicle, double gravity) {
  Topology topology = topologyOf(vehicle);
  Rest rest = restOf(topology, gravity);
  std::vector<SuspensionLawPtr> laws = lawsOf(topology);
  const StateLayout states{.coordinates = topology.coordinates};
  OutputLayout outputs(topology);
  std::vector<OutputKey> state_keys = stateKeys(topology);
  std::vector<Channel> state_channels = stateChannels(outputs, state_keys);
  const InputLayout inputs{static_cast<int>(topology.wheelsets.size())};
  return {std::move(vehicle), gravity, std::move(topology),   std::move(rest),
          std::move(laws),    states,  std::move(state_keys), std::move(state_channels),
          std::move(outputs), inputs};
}

}  // namespace vehicle
