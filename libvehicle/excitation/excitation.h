#pragma once

#include <vector>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/excitation/travel.h"
#include "libvehicle/model/topology.h"
#include "libvehicle/system/input.h"
#include "libvehicle/track/rail_piece.h"

namespace vehicle {

/// Most memory that the coefficients of an input may take [byte]. Every wheelset meets the breakpoints of a rail at its own
/// time, so their number grows with the square of a train's length.
inline constexpr double kMostInputBytes = 1024.0 * 1024.0 * 1024.0;

/// The rail (or rig) of a scenario as the input of the vehicle's wheelsets, in the order of topology.wheelsets,
/// from t = 0 to the end of the run (duration, or distance / speed), cut exactly at its breakpoints.
///
/// Wheel j reads the profile at s = V t - (x_lead - x_j); x_lead is the largest x of all wheelsets. Breakpoints: a
/// wheel reaches s = 0 of an `onset` profile, the end of a fade-in, the start or end of a dip or ramp, as far as
/// that happens within the run. Breakpoints of several wheels within 1e-9 of an output step of each other are one;
/// within 1e-9 of an output step of an output sample they are that sample, i * output_step.
/// A fade-in acts on harmonics only. A rig has no breakpoints: its sines have always been there.
///
/// @param speed  [m/s] > 0; the scenario's own or one given on the command line
/// @throws InvalidInput  for an onset whose height jumps (names fade_in="50 m" as the remedy), a feature that is
///                       passed within 1e-8 of an output step, a rig input for a wheelset that is not there, a
///                       run without length or shorter than an output step, an input above kMostInputBytes (names
///                       history="extended" as the remedy of an onset)
/// @throws std::invalid_argument  unless speed is finite and > 0 (where a track or a distance needs it)
[[nodiscard]] Input inputOf(const Scenario& scenario, const Topology& topology, double speed);

/// How long a run is and how finely it is looked at.
struct RunLength {
  double end = 0.0;           // [s]
  double output_step = 5e-3;  // [s] > 0
};

/// Any rail over distance as the input of the vehicle's wheelsets, who run over it as the travel says: wheel j reads at
/// s(t) - (x_lead - x_j). At constant speed pieces of closed form stay closed forms; sampled pieces, and all of them where the
/// speed changes, become sampled terms: one a wheelset and piece, however many samples there are. Breakpoints as above,
/// and where the acceleration jumps.
/// @throws std::invalid_argument  unless the run lasts at least one output step
/// @throws InvalidInput           an input above kMostInputBytes
[[nodiscard]] Input inputOf(const std::vector<RailPiece>& rail, const Topology& topology, const Travel& travel,
                            const RunLength& run);

/// Times of the breakpoints of an input [s]: the borders between its segments, ends of the run not included.
[[nodiscard]] std::vector<double> breakpointsOf(const Input& input);

}  // namespace vehicle
