#pragma once

#include "libvehicle/definition/vehicle.h"
#include "libvehicle/diagnostics/warning.h"

namespace vehicle {

/// All that is doubtful of a vehicle's file: geometryWarnings(), restWarnings() and motionWarnings() of its matrix form,
/// those of equal vehicles of a train once, and FREE_MODE left out where FREE_PITCH names the reason.
/// @param vehicle  in order by its own check()
/// @param gravity  [m/s^2] that it rests under
/// @throws InvalidInput if its springs cannot carry the weight
[[nodiscard]] Warnings fileWarnings(const Vehicle& vehicle, double gravity);

}  // namespace vehicle
