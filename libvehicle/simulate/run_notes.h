#pragma once

#include <string>
#include <vector>

#include "libvehicle/simulate/simulate.h"

namespace vehicle {

/// What a caller should know of a finished run: what was chosen for it, why its threads were left at one, that it was
/// stiff (stiffness.h).
/// @param choice  that the result was run with
[[nodiscard]] std::vector<std::string> notesOn(const CompiledModel& model, const Scenario& scenario,
                                               const RunChoice& choice, const RunResult& result);

/// The same for runs at several speeds, each sentence once.
/// @param choice  of all runs, but for the speed
[[nodiscard]] std::vector<std::string> notesOn(const CompiledModel& model, const Scenario& scenario,
                                               const RunChoice& choice, const std::vector<RunResult>& runs);

}  // namespace vehicle
