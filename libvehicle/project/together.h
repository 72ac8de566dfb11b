#pragma once

#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/vehicle.h"
#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/model/compiled_model.h"

namespace vehicle {

/// What a vehicle hides whose own values are right: a weight that its springs cannot carry.
/// @param gravity  [m/s^2]
[[nodiscard]] ProblemList checkRest(const Vehicle& vehicle, double gravity);

/// What a run of this vehicle over this scenario would be refused for before its first step: parts that the vehicle
/// does not have, a weight that its springs cannot carry, a rail that jumps under it, an initial state that does not
/// exist.
/// @param vehicle, scenario  in order by their own check()
/// @param speed  [m/s] the scenario's own, or another one that it is run at
[[nodiscard]] ProblemList checkTogether(const Vehicle& vehicle, const Scenario& scenario, double speed);
/// The same of a vehicle that is compiled under the scenario's gravity.
[[nodiscard]] ProblemList checkTogether(const CompiledModel& model, const Scenario& scenario, double speed);

}  // namespace vehicle
