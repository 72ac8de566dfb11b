#pragma once

#include <vector>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/model/compiled_model.h"
#include "libvehicle/system/input.h"
#include "libvehicle/system/system.h"

namespace vehicle {

/// State at t = 0 as the scenario asks for it: zero, at rest on the rail's height, or on the steady state of
/// harmonics that have always been there; what the scenario lists for bodies is added.
///
/// Rest and steady state come from the form's own matrices; a nonlinear form starts from those of the matrix
/// form, which are its linearisation about rest (difference ~ amplitude^2).
/// @throws InvalidInput if there is no such rest (nothing holds a coordinate) or no steady state (an undamped
///         mode at resonance), at the place of <initial_state>
[[nodiscard]] std::vector<double> initialState(const System& system, const CompiledModel& model,
                                               const Scenario& scenario, const Input& input);

}  // namespace vehicle
