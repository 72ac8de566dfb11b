#pragma once

#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/topology.h"
#include "libvehicle/system/input.h"

namespace vehicle {

/// The rail (or rig) of a scenario as the input of the vehicle's wheelsets, cut exactly at its kinks.
///
/// Wheel j reads the profile at s = V t - (x_lead - x_j); x_lead is the largest x of all wheelsets. Kinks: a
/// wheel reaches s = 0 of an `onset` profile, the end of a fade-in, the start or end of a dip or ramp. Kinks of
/// several wheels within 1e-9 of an output step of each other are one; within 1e-9 of an output step of an
/// output sample they are that sample, i * output_step.
///
/// @param speed  [m/s] > 0; the scenario's own or one given on the command line
/// @throws InvalidInput for an onset whose height jumps (names fade_in="50 m" as the remedy)
[[nodiscard]] Input inputOf(const Scenario& scenario, const Topology& topology, double speed);

}  // namespace vehicle
