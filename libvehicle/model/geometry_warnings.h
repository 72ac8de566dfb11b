#pragma once

#include "libvehicle/diagnostics/warning.h"
#include "libvehicle/model/rest.h"

namespace vehicle {

/// Places that no real vehicle has, each with file and line; all of them are most often an x that was forgotten:
///     FREE_PITCH         a body may pitch, but its springs stand at one place within 1 mm, and gravity does not hold
///                        it either: nothing resists the pitch
///     FAR_FROM_WHEELSET  a suspension stands more than 0.75 m from the wheelset that it stands on
///     SAME_PLACE         two axles, of one vehicle or of two of a train, are closer than 0.3 m: their wheels overlap
///     OVERLAP            vehicles of a train stand in each other: what they hold along x (axles, bodies, suspensions,
///                        coupled ends) reaches past what the next one holds
/// Equal vehicles of a train give one warning.
/// @param topology, rest  of the vehicle
[[nodiscard]] Warnings geometryWarnings(const Vehicle& vehicle, const Topology& topology, const Rest& rest);

}  // namespace vehicle
