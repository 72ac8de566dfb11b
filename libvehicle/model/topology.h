#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libvehicle/definition/vehicle.h"

namespace vehicle {

// The vehicle with its names looked up, its groups dissolved and its sides summed: what every form starts
// from. It holds places and coefficients only; how they make equations is each form's own business.
//
// Coordinates q: for each body in file order z, then pitch, as far as it moves; then z of each wheelset that
// has a motion of its own, in file order. State x = (q, q').

struct TopologyBody {
  std::string name;
  Origin origin;               // where the file says it; a group's or train's parts know their own file
  double mass = 0.0;           // [kg]
  double pitch_inertia = 0.0;  // [kg m^2]; 0 where it does not pitch and none is given
  double x = 0.0;              // [m] absolute
  double z = 0.0;              // [m]; 0 without heights
  int z_index = -1;            // in q; -1: does not move so
  int pitch_index = -1;        // in q
};

struct TopologyWheelset {
  std::string name;
  Origin origin;
  double x = 0.0;                           // [m] absolute
  double z = 0.0;                           // [m]; 0 without heights
  double mass = 0.0;                        // [kg]; 0: none given
  double contact_damping = 0.0;             // [N s/m]
  std::optional<double> load;               // [N] static, as given
  std::optional<double> contact_stiffness;  // [N/m] as given
  std::optional<double> hertz_constant;     // [N/m^1.5] as given
  int z_index = -1;                         // in q; -1: follows the rail
};

/// A suspension: both sides together.
struct TopologySuspension {
  std::string name;
  Origin origin;
  double stiffness = 0.0;  // [N/m]   sides x element
  double damping = 0.0;    // [N s/m]
  int upper = -1;          // body
  int lower_body = -1;     // exactly one of lower_body and lower_wheelset is >= 0
  int lower_wheelset = -1;
  double x = 0.0;                 // [m] absolute, of its upper end; the lower one stands there too but in a coupling
  double arm_upper = 0.0;         // [m] x - x of the upper body's centre of gravity
  double arm_lower = 0.0;         // [m] x of its lower end - x of the lower body's; 0 for a wheelset
  double height_upper = 0.0;      // [m] of its upper end above the upper body's centre of gravity; 0 without heights
  double height_lower = 0.0;      // [m] of its lower end above the lower body's (or axle); 0 without heights
  std::optional<double> preload;  // [N] compression, as given
};

struct TopologyPoint {
  std::string name;
  int body = -1;
  double arm = 0.0;  // [m]
};

struct Topology {
  std::string name;       // of the vehicle or train
  Origin origin;          // where its file begins
  std::size_t units = 0;  // vehicles of a train; 0: a vehicle of its own
  std::vector<TopologyBody> bodies;
  std::vector<TopologyWheelset> wheelsets;  // in file order: this is the order of the input channels
  std::vector<TopologySuspension> suspensions;
  std::vector<TopologyPoint> points;
  int coordinates = 0;       // size of q
  bool has_heights = false;  // without heights gravity drops out of pitch
};

/// @param vehicle  that check() finds nothing wrong with; compile() is what a caller who is not sure of it takes
[[nodiscard]] Topology topologyOf(const Vehicle& vehicle);

/// What can be said of a vehicle that contradicts itself, so that the checks beyond definition's own reach the rest of
/// it too: parts with problems, and all whose loads could depend on them, do not move in it, so that a judge of motions
/// and loads passes over them. Of a vehicle without problems it is topologyOf().
[[nodiscard]] Topology soundTopologyOf(const Vehicle& vehicle);

}  // namespace vehicle
