#pragma once

#include "libvehicle/definition/vehicle.h"
#include "libvehicle/diagnostics/warning.h"
#include "libvehicle/statics/rest.h"

namespace vehicle {

/// All that is doubtful of a vehicle's file: geometryWarnings() and restWarnings(), those of equal vehicles of a train
/// once, and FREE_MODE left out where FREE_PITCH names the reason.
/// @param topology, rest  of the vehicle
/// @param gravity         [m/s^2] of that rest
[[nodiscard]] Warnings fileWarnings(const Vehicle& vehicle, const Topology& topology, const Rest& rest, double gravity);

}  // namespace vehicle
