#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libvehicle/definition/origin.h"

namespace vehicle {

// What the vehicle meets: speed, rail (or rig) and initial state, plain data in SI. Distance s along the
// track counts from the leading wheelset's position at t = 0; wheel j stands at s = V t - (x_lead - x_j).

/// What the rail was before the vehicle came.
enum class History {
  kOnset,     // height 0 for s < 0
  kExtended,  // the profile exists for all s
};

/// Which rail a member of the track lies on. Planar forms see the mean of both: a member of one rail counts half.
enum class RailSide {
  kBoth,
  kLeft,
  kRight,
};

/// Share of a member in the mean of both rails: 1/2 of a member that lies on one of them.
[[nodiscard]] constexpr double shareOf(RailSide rail) { return rail == RailSide::kBoth ? 1.0 : 0.5; }

/// height = amplitude sin(2 pi order s / wavelength + phase)
struct Harmonic {
  std::string name;
  double wavelength = 0.0;  // [m]    > 0
  double order = 1.0;       // [-]    > 0
  double amplitude = 0.0;   // [m]
  double phase = 0.0;       // [rad]
  RailSide rail = RailSide::kBoth;
  Origin origin;
  bool operator==(const Harmonic&) const = default;
};

/// Form of a dip or a bump of height h, positive upward; x = (s - start)/length from 0 to 1.
enum class DipShape {
  kOneMinusCosine,  // h/2 (1 - cos(2 pi x))
  kHalfSine,        // h sin(pi x)
};

struct Dip {
  std::string name;
  DipShape shape = DipShape::kOneMinusCosine;
  double depth = 0.0;   // [m] positive downward
  double length = 0.0;  // [m] > 0
  double start = 0.0;   // [m]
  RailSide rail = RailSide::kBoth;
  Origin origin;
  bool operator==(const Dip&) const = default;
};

/// A dip turned upward: the same shapes.
struct Bump {
  std::string name;
  DipShape shape = DipShape::kOneMinusCosine;
  double height = 0.0;  // [m] positive upward
  double length = 0.0;  // [m] > 0
  double start = 0.0;   // [m]
  RailSide rail = RailSide::kBoth;
  Origin origin;
  bool operator==(const Bump&) const = default;
};

/// Linear by `rise` over `length` from `start`, constant afterwards.
struct Ramp {
  std::string name;
  double rise = 0.0;    // [m] positive upward
  double length = 0.0;  // [m] > 0
  double start = 0.0;   // [m]
  RailSide rail = RailSide::kBoth;
  Origin origin;
  bool operator==(const Ramp&) const = default;
};

struct Track {
  History history = History::kOnset;
  /// [m] > 0: with onset, harmonics are multiplied by (1 - cos(pi s/fade_in))/2 until s = fade_in
  std::optional<double> fade_in;
  std::vector<Harmonic> harmonics;
  std::vector<Dip> dips;
  std::vector<Ramp> ramps;
  std::vector<Bump> bumps;
  Origin origin;
  bool operator==(const Track&) const = default;
};

/// height = amplitude sin(w t + phase), for all t; w = angular_frequency or 2 pi frequency
struct RigSine {
  std::string name;
  double amplitude = 0.0;                   // [m]
  std::optional<double> angular_frequency;  // [rad/s] > 0; exactly one of the two
  std::optional<double> frequency;          // [Hz] > 0
  double phase = 0.0;                       // [rad]
  Origin origin;
  bool operator==(const RigSine&) const = default;
};

/// w [rad/s] of a sine that gives one of the two.
[[nodiscard]] double angularFrequencyOf(const RigSine& sine);

/// What a rig does under one wheelset: the sum of its sines. Wheelsets without input stay at 0.
struct RigInput {
  std::string wheelset;
  std::vector<RigSine> sines;
  Origin origin;
  bool operator==(const RigInput&) const = default;
};

struct Rig {
  std::vector<RigInput> inputs;
  Origin origin;
  bool operator==(const Rig&) const = default;
};

enum class InitialRest {
  kZero,      // all displacements and velocities 0
  kOnRail,    // rest on the rail's height at t = 0
  kPeriodic,  // the steady state under harmonics that have always been there
};

/// Displacements and velocities of a body (or of a wheelset with a motion of its own), added to the rest.
struct InitialBody {
  std::string name;
  double z = 0.0;           // [m]
  double pitch = 0.0;       // [rad]
  double z_rate = 0.0;      // [m/s]
  double pitch_rate = 0.0;  // [rad/s]
  Origin origin;
  bool operator==(const InitialBody&) const = default;
};

struct InitialState {
  InitialRest from = InitialRest::kZero;
  std::vector<InitialBody> bodies;
  Origin origin;
  bool operator==(const InitialState&) const = default;
};

struct Run {
  double speed = 0.0;                // [m/s] > 0 on a track; a rig has no need of it
  std::optional<double> duration;    // [s] > 0; exactly one of duration and distance
  std::optional<double> distance;    // [m] > 0
  double output_step = 0.005;        // [s] > 0
  Origin origin;
  bool operator==(const Run&) const = default;
};

struct Scenario {
  std::string name;
  std::string title;
  std::string source;
  double gravity = 9.81;  // [m/s^2] >= 0
  Run run;
  std::optional<Track> track;  // exactly one of track and rig
  std::optional<Rig> rig;
  InitialState initial_state;
  Origin origin;
  bool operator==(const Scenario&) const = default;
};

/// Whether the track has members that a vehicle meets once: then there is no steady state.
[[nodiscard]] bool hasSingleFeatures(const Track& track);

/// Whether wheels roll, on a track or over a distance; on a rig with a duration the speed has no effect.
[[nodiscard]] bool wheelsRoll(const Scenario& scenario);

/// Time the run lasts [s]: duration, or distance / speed.
[[nodiscard]] double durationOf(const Scenario& scenario);

/// Contradictions within the scenario. With history="onset" each rail must begin at 0, not only their mean.
[[nodiscard]] ProblemList check(const Scenario& scenario);
/// Names in the scenario that the vehicle does not have (rig inputs, initial state), as far as both could be read.
[[nodiscard]] ProblemList check(const Scenario& scenario, const struct Vehicle& vehicle);
/// All of it before a run: the vehicle, the scenario, and where each is right the two together.
/// @throws InvalidInput  all problems that were found
void requireRight(const struct Vehicle& vehicle, const Scenario& scenario);

}  // namespace vehicle
