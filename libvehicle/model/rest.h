#pragma once

#include <vector>

#include "libvehicle/model/topology.h"

namespace vehicle {

/// The loaded rest position: what each spring carries and how far everything has come down.
///
/// With all springs unloaded at zero deflection, K d = -m g gives the deflections d; the load of a spring is
/// its stiffness times its compression. Where equilibrium alone leaves a choice (two axles under a bogie
/// that does not pitch) this is the equal deflection of the springs. A preload that is given replaces the
/// spring's own; the others carry the rest. A motion that given preloads hold alone has no unloaded position of
/// its own and stays at 0. A wheelset on a Hertz spring F = C delta^1.5 comes down by (F / C)^(2/3).
struct Rest {
  std::vector<double> coordinates;      // [m, rad] (q) deflection from the unloaded to the rest position
  std::vector<double> suspension_load;  // [N] (suspensions) compression-positive
  std::vector<double> wheel_load;       // [N] (wheelsets) wheel-rail force Q0, own weight included; `load` where given
  /// [N m/rad] (bodies) what static loads add to a body's pitch stiffness: sum over its suspensions of F0 z_a,
  /// F0 the static upward force on the body at the attachment, z_a the attachment's height above its centre
  /// of gravity. 0 without heights. Negative (it destabilises) where a body stands on springs below its CG.
  std::vector<double> pitch_stiffness;
  /// [N/m] (wheelsets) given, or 1.5 C^(2/3) Q0^(1/3) of the Hertz constant; 0 where it follows the rail
  std::vector<double> contact_stiffness;
};

/// @param gravity  [m/s^2] >= 0
/// @throws InvalidInput if springs or given preloads cannot carry the weight, naming the body or wheelset: a
///         force or moment left over beyond 1e-6 of what acts there, a wheel pulled off the rail, or a Hertz
///         contact without a static load
/// @throws std::invalid_argument unless gravity is finite and >= 0
[[nodiscard]] Rest restOf(const Topology& topology, double gravity);

}  // namespace vehicle
