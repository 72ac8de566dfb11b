#pragma once

#include "libvehicle/diagnostics/warning.h"
#include "libvehicle/model/compiled_model.h"

namespace vehicle {

/// All that is doubtful of a vehicle's file: geometryWarnings(), restWarnings() and motionWarnings() of its matrix form,
/// those of equal vehicles of a train once, and FREE_MODE left out where FREE_PITCH names the reason.
[[nodiscard]] Warnings fileWarnings(const CompiledModel& model);

}  // namespace vehicle
