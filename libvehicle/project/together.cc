#include "libvehicle/project/together.h"

#include <memory>

#include "libvehicle/excitation/excitation.h"
#include "libvehicle/simulate/forms.h"
#include "libvehicle/simulate/initial_state.h"
#include "libvehicle/statics/rest.h"

namespace vehicle {

ProblemList checkRest(const Vehicle& vehicle, double gravity) {
  try {
    static_cast<void>(restOf(topologyOf(vehicle), gravity));
  } catch (const InvalidInput& wrong) {
    return wrong.problems();
  }
  return {};
}

ProblemList checkTogether(const Vehicle& vehicle, const Scenario& scenario, double speed) {
  if (ProblemList problems = check(scenario, vehicle); !problems.empty()) return problems;
  if (ProblemList problems = checkRest(vehicle, scenario.gravity); !problems.empty()) return problems;
  try {
    const Input input = inputOf(scenario, topologyOf(vehicle), speed);
    if (scenario.initial_state.from == InitialRest::kZero) return {};  // else a form's matrices decide
    const std::unique_ptr<System> form = buildForm(defaultForm(vehicle), vehicle, scenario.gravity);
    static_cast<void>(initialState(*form, vehicle, scenario, input));
  } catch (const InvalidInput& wrong) {
    return wrong.problems();
  }
  return {};
}

}  // namespace vehicle
