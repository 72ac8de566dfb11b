#include "libvehicle/project/together.h"

#include <memory>

#include "libvehicle/excitation/excitation.h"
#include "libvehicle/simulate/forms.h"
#include "libvehicle/simulate/initial_state.h"

namespace vehicle {

ProblemList checkRest(const Vehicle& vehicle, double gravity) {
  try {
    static_cast<void>(compileChecked(vehicle, gravity));
  } catch (const InvalidInput& wrong) {
    return wrong.problems();
  }
  return {};
}

ProblemList checkTogether(const CompiledModel& model, const Scenario& scenario, double speed) {
  if (ProblemList problems = check(scenario, model.vehicle); !problems.empty()) return problems;
  try {
    const Input input = inputOf(scenario, model.topology, speed);
    if (scenario.initial_state.from == InitialRest::kZero) return {};  // else a form's matrices decide
    const std::unique_ptr<System> form = buildForm(defaultForm(model.topology), model);
    static_cast<void>(initialState(*form, model, scenario, input));
  } catch (const InvalidInput& wrong) {
    return wrong.problems();
  }
  return {};
}

ProblemList checkTogether(const Vehicle& vehicle, const Scenario& scenario, double speed) {
  if (ProblemList problems = check(scenario, vehicle); !problems.empty()) return problems;
  try {
    return checkTogether(compileChecked(vehicle, scenario.gravity), scenario, speed);
  } catch (const InvalidInput& wrong) {
    return wrong.problems();
  }
}

}  // namespace vehicle
