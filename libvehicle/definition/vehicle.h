#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/definition/origin.h"

namespace vehicle {

// A vehicle as the user said it: plain data in SI, parts tied by name. Nothing here moves or computes.
// Axes: x forward from an arbitrary origin, y left, z up from rail top at loaded rest. An `x` inside a group
// counts from the group's x; topology.h gives absolute places.

/// What a spring and damper are made of; every suspension that names it has these values.
struct Element {
  std::string name;
  double stiffness_z = 0.0;  // [N/m]    >= 0
  double damping_z = 0.0;    // [N s/m]  >= 0
  std::vector<ReservedQuantity> reserved;
  Origin origin;
  bool operator==(const Element&) const = default;
};

/// Motions a body may have. The planar forms use kZ and kPitch.
enum class Motion { kX, kY, kZ, kRoll, kPitch, kYaw };

/// As files write it: "x", "y", "z", "roll", "pitch", "yaw".
[[nodiscard]] std::string_view nameOf(Motion motion);

/// A rigid body on springs: carbody, bogie frame.
struct Body {
  std::string name;
  std::string group;                    // "" or the name of the group it stands in
  double mass = 0.0;                    // [kg]      > 0
  std::optional<double> pitch_inertia;  // [kg m^2]  > 0 where the body pitches
  double x = 0.0;                       // [m] of the centre of gravity
  std::optional<double> z;              // [m] height of the centre of gravity above rail top
  std::vector<Motion> motion;           // as listed in the file, no repeats, not empty
  std::vector<ReservedQuantity> reserved;
  Origin origin;
  bool operator==(const Body&) const = default;
};

/// One axle. Without mass it follows the rail; with mass and contact stiffness it has a motion z of its own;
/// with mass and no contact it follows the rail and m eta'' enters its load.
struct Wheelset {
  std::string name;
  std::string group;
  double x = 0.0;                           // [m]
  std::optional<double> z;                  // [m] height of the axle above rail top
  std::optional<double> mass;               // [kg]       > 0
  std::optional<double> load;               // [N] static wheel-rail force Q0, > 0; else from statics
  std::optional<double> contact_stiffness;  // [N/m]      > 0
  std::optional<double> contact_damping;    // [N s/m]    >= 0
  std::optional<double> hertz_constant;     // [N/m^1.5]  > 0, F = C delta^1.5
  std::vector<ReservedQuantity> reserved;
  Origin origin;
  bool operator==(const Wheelset&) const = default;
};

/// A spring and damper between two parts, acting vertically.
struct Suspension {
  std::string name;
  std::string group;
  std::string element;
  std::string upper;               // a body
  std::string lower;               // a body or a wheelset
  double x = 0.0;                  // [m]
  std::optional<double> x_lower;   // [m] of its lower end, in the group too; else x. Couplings of a train alone have it
  std::optional<double> z_upper;   // [m] height of its upper end above rail top
  std::optional<double> z_lower;   // [m]
  std::optional<double> y;         // [m] with sides = 2: one at +y, one at -y
  int sides = 1;                   // 1 or 2; 2 doubles stiffness and damping
  std::optional<double> preload;   // [N] static load it carries, positive in compression; else from statics
  std::vector<ReservedQuantity> reserved;
  Origin origin;
  bool operator==(const Suspension&) const = default;
};

/// Parts that move together when the group's x is changed.
struct Group {
  std::string name;
  double x = 0.0;  // [m]
  Origin origin;
  bool operator==(const Group&) const = default;
};

/// A measuring point on a body.
struct Point {
  std::string name;
  std::string group;
  std::string body;
  double x = 0.0;  // [m]
  Origin origin;
  bool operator==(const Point&) const = default;
};

/// A vehicle inside a train. Its parts are called "coach_2.carbody": its name, a dot, their own.
struct TrainUnit {
  std::string name;   // "coach_2": unique in the train
  std::string title;  // of its vehicle
  double x = 0.0;     // [m] of its vehicle's origin
  Origin origin;      // of the <vehicle> of the train's file
  bool operator==(const TrainUnit&) const = default;
};

struct Vehicle {
  std::string name;
  std::string title;
  std::string source;
  std::vector<Element> elements;
  std::vector<Group> groups;
  std::vector<Body> bodies;
  std::vector<Wheelset> wheelsets;
  std::vector<Suspension> suspensions;
  std::vector<Point> points;
  std::vector<TrainUnit> units;  // of a train (train.h), the leading one first; none: a vehicle of its own
  Origin origin;
  bool operator==(const Vehicle&) const = default;
};

/// Whether the body's motion names it.
[[nodiscard]] bool moves(const Body& body, Motion motion);
/// Whether the wheelset has a height of its own instead of following the rail: mass on a contact spring.
[[nodiscard]] bool hasOwnMotion(const Wheelset& wheelset);

/// Contradictions that no single value shows: duplicate names, dangling references, a body that nothing
/// carries, heights given for some parts only, non-finite or non-positive values, ...
[[nodiscard]] ProblemList check(const Vehicle& vehicle);

}  // namespace vehicle
