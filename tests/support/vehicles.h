#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/vehicle.h"

// Vehicles and scenarios built by hand, so that no test of physics or numerics needs a file or a reader.
namespace vehicle::test {

inline Element element(std::string name, double stiffness, double damping) {
  Element made;
  made.name = std::move(name);
  made.stiffness_z = stiffness;
  made.damping_z = damping;
  return made;
}

inline Body body(std::string name, double mass, double x, std::optional<double> pitch_inertia,
                 std::vector<Motion> motion) {
  Body made;
  made.name = std::move(name);
  made.mass = mass;
  made.x = x;
  made.pitch_inertia = pitch_inertia;
  made.motion = std::move(motion);
  return made;
}

inline Wheelset wheelset(std::string name, double x) {
  Wheelset made;
  made.name = std::move(name);
  made.x = x;
  return made;
}

inline Suspension suspension(std::string name, std::string element_name, std::string upper, std::string lower,
                             double x) {
  Suspension made;
  made.name = std::move(name);
  made.element = std::move(element_name);
  made.upper = std::move(upper);
  made.lower = std::move(lower);
  made.x = x;
  return made;
}

/// The part of that name; the tests name parts that exist.
template <class Part>
Part& named(std::vector<Part>& parts, const std::string& name) {
  for (Part& part : parts) {
    if (part.name == name) return part;
  }
  throw std::invalid_argument("no part " + name);
}

/// One bogie's numbers, distances in the symmetric vehicles below.
struct BogieNumbers {
  double mass;                           // [kg]
  std::optional<double> pitch_inertia;   // [kg m^2]; given: the bogie pitches
  double half_wheelbase;                 // [m]
};

/// A measuring point, x [m] as the body counts.
inline Point pointOn(std::string name, std::string body_name, double x) {
  Point made;
  made.name = std::move(name);
  made.body = std::move(body_name);
  made.x = x;
  return made;
}

/// Carbody on two equal bogies on four wheelsets, CG of the carbody at x = 0, no groups, no heights.
/// Coordinates: carbody.z, carbody.pitch, front_bogie.z, (front_bogie.pitch,) rear_bogie.z, (rear_bogie.pitch)
inline Vehicle symmetricVehicle(std::string name, double carbody_mass, double carbody_inertia, double half_pivots,
                                const BogieNumbers& bogie, const Element& primary, const Element& secondary) {
  const std::vector<Motion> both = {Motion::kZ, Motion::kPitch};
  const std::vector<Motion> bogie_motion = bogie.pitch_inertia ? both : std::vector<Motion>{Motion::kZ};
  const double far = half_pivots + bogie.half_wheelbase;
  const double near = half_pivots - bogie.half_wheelbase;
  Vehicle made;
  made.name = std::move(name);
  made.elements = {primary, secondary};
  made.bodies = {body("carbody", carbody_mass, 0.0, carbody_inertia, both),
                 body("front_bogie", bogie.mass, half_pivots, bogie.pitch_inertia, bogie_motion),
                 body("rear_bogie", bogie.mass, -half_pivots, bogie.pitch_inertia, bogie_motion)};
  made.wheelsets = {wheelset("wheelset_1", far), wheelset("wheelset_2", near), wheelset("wheelset_3", -near),
                    wheelset("wheelset_4", -far)};
  made.suspensions = {suspension("secondary_front", secondary.name, "carbody", "front_bogie", half_pivots),
                      suspension("secondary_rear", secondary.name, "carbody", "rear_bogie", -half_pivots),
                      suspension("primary_1", primary.name, "front_bogie", "wheelset_1", far),
                      suspension("primary_2", primary.name, "front_bogie", "wheelset_2", near),
                      suspension("primary_3", primary.name, "rear_bogie", "wheelset_3", -near),
                      suspension("primary_4", primary.name, "rear_bogie", "wheelset_4", -far)};
  return made;
}

/// The paper's vehicle (Al-Oraiqat), 4 coordinates: carbody.z, carbody.pitch, front_bogie.z, rear_bogie.z.
/// @param carbody_inertia  [kg m^2] Jk: 70 t m^2, or 70 tf m s^2 = 686465.5 kg m^2
inline Vehicle paperVehicle(double carbody_inertia = 70e3) {
  return symmetricVehicle("al-oraiqat-2017", 57e3, carbody_inertia, 3.725, {9e3, std::nullopt, 1.5},
                          element("primary", 3040e3, 30e3), element("secondary", 2660e3, 100e3));
}

/// Manchester benchmark coach, 6 coordinates (bogies pitch), wheelsets of 1813 kg that follow the rail.
inline Vehicle bogiePitchVehicle() {
  Vehicle made = symmetricVehicle("manchester-coach", 32e3, 1.97e6, 9.5, {2615.0, 1476.0, 1.28},
                                  element("primary", 2440e3, 8e3), element("secondary", 860e3, 40e3));
  for (Wheelset& each : made.wheelsets) each.mass = 1813.0;
  return made;
}

/// The Manchester coach with its wheelsets on linear contact springs: 10 coordinates, wheelsets last.
inline Vehicle contactVehicle() {
  Vehicle made = bogiePitchVehicle();
  made.name = "contact";
  for (Wheelset& each : made.wheelsets) {
    each.contact_stiffness = 2.4e9;
    each.contact_damping = 20e3;
  }
  return made;
}

/// The same on Hertz springs, F = C delta^1.5, both wheels of a wheelset together.
inline Vehicle hertzVehicle() {
  Vehicle made = bogiePitchVehicle();
  made.name = "hertz";
  for (Wheelset& each : made.wheelsets) each.hertz_constant = 200e9;
  return made;
}

/// Front and rear differ in everything, the carbody's CG (x = 2.3 m) is off the middle of the pivots (6.0 and
/// -2.5 m), the two axles of a bogie differ, and the file names the rear first. 4 coordinates in file order:
/// rear_bogie.z, carbody.z, carbody.pitch, front_bogie.z.
inline Vehicle asymmetricVehicle() {
  Vehicle made;
  made.name = "asymmetric";
  made.elements = {element("secondary_soft", 1.9e6, 85e3), element("primary_a", 2.7e6, 21e3),
                   element("primary_b", 3.4e6, 33e3),      element("primary_c", 2.2e6, 45e3),
                   element("secondary_hard", 3.1e6, 60e3), element("primary_d", 3.9e6, 12e3)};
  made.bodies = {body("rear_bogie", 7.5e3, -2.5, std::nullopt, {Motion::kZ}),
                 body("carbody", 48e3, 2.3, 310e3, {Motion::kZ, Motion::kPitch}),
                 body("front_bogie", 10.2e3, 6.0, std::nullopt, {Motion::kZ})};
  made.wheelsets = {wheelset("wheelset_3", -1.4), wheelset("wheelset_1", 7.6), wheelset("wheelset_4", -3.6),
                    wheelset("wheelset_2", 4.5)};
  made.suspensions = {suspension("primary_4", "primary_d", "rear_bogie", "wheelset_4", -3.6),
                      suspension("secondary_rear", "secondary_soft", "carbody", "rear_bogie", -2.5),
                      suspension("primary_1", "primary_a", "front_bogie", "wheelset_1", 7.6),
                      suspension("primary_3", "primary_c", "rear_bogie", "wheelset_3", -1.4),
                      suspension("secondary_front", "secondary_hard", "carbody", "front_bogie", 6.0),
                      suspension("primary_2", "primary_b", "front_bogie", "wheelset_2", 4.5)};
  return made;
}

/// The same with bogies that pitch and secondaries off the bogie's CG (0.2 m ahead, 0.15 m behind): 6 coordinates:
/// rear_bogie.z, rear_bogie.pitch, carbody.z, carbody.pitch, front_bogie.z, front_bogie.pitch.
inline Vehicle asymmetricBogiePitchVehicle() {
  Vehicle made = asymmetricVehicle();
  made.name = "asymmetric-bogie-pitch";
  Body& front = named(made.bodies, "front_bogie");
  front.pitch_inertia = 11e3;
  front.motion = {Motion::kZ, Motion::kPitch};
  Body& rear = named(made.bodies, "rear_bogie");
  rear.pitch_inertia = 5.6e3;
  rear.motion = {Motion::kZ, Motion::kPitch};
  named(made.suspensions, "secondary_front").x = 6.2;
  named(made.suspensions, "secondary_rear").x = -2.65;
  return made;
}

/// Gives a vehicle heights: every suspension is attached `below` metres under the CG of each body it joins.
/// @param below  [m]
inline Vehicle withHeights(Vehicle made, double below) {
  constexpr double kCarbody = 2.1, kBogie = 0.95, kAxle = 0.46;  // [m] above rail top
  for (Body& each : made.bodies) each.z = each.name == "carbody" ? kCarbody : kBogie;
  for (Wheelset& each : made.wheelsets) each.z = kAxle;
  for (Suspension& each : made.suspensions) {
    each.z_upper = *named(made.bodies, each.upper).z - below;
    const bool onBogie = each.lower.find("bogie") != std::string::npos;
    each.z_lower = onBogie ? kBogie - below : kAxle;
  }
  return made;
}

/// The paper's vehicle with heights, attachments 0.5 m below the CG unless said otherwise; 4 coordinates.
inline Vehicle heightsVehicle(double below = 0.5) {
  Vehicle made = withHeights(paperVehicle(), below);
  made.name = "heights";
  return made;
}

/// The Manchester coach with heights, so that bogies pitch under static loads too; 6 coordinates.
inline Vehicle bogiePitchHeightsVehicle(double below = 0.5) {
  Vehicle made = withHeights(bogiePitchVehicle(), below);
  made.name = "bogie-pitch-heights";
  return made;
}

inline Harmonic harmonic(double wavelength, double order, double amplitude, double phase = 0.0) {
  Harmonic made;
  made.wavelength = wavelength;
  made.order = order;
  made.amplitude = amplitude;
  made.phase = phase;
  return made;
}

/// The paper's rail: 5 mm at 25 m and 2 mm at 25/3 m, 20 m/s, 10 s, a sample every 5 ms, from rest.
inline Scenario paperScenario(History history) {
  Track track;
  track.history = history;
  track.harmonics = {harmonic(25.0, 1.0, 5e-3), harmonic(25.0, 3.0, 2e-3)};
  Scenario made;
  made.name = history == History::kOnset ? "paper-20mps" : "paper-20mps-extended";
  made.run.speed = 20.0;
  made.run.duration = 10.0;
  made.run.output_step = 5e-3;
  made.track = track;
  return made;
}

}  // namespace vehicle::test
