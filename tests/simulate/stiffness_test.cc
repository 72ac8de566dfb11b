#include "libvehicle/simulate/stiffness.h"

#include <complex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle {
namespace {

using Complex = std::complex<double>;

Statistics ofSteps(long steps) {
  Statistics statistics;
  statistics.steps = steps;
  return statistics;
}

// A mode that dies away at 3300 1/s beside one of 6 rad/s, over waves of 5 rad/s. Dormand and Prince's method errs by
// |h lambda|^6 / 3600 of a mode in a step.
const std::vector<Complex> kStiffModes = {{-3300.0, 0.0}, {-1.0, 6.0}, {-1.0, -6.0}, {0.0, 0.0}};
constexpr FollowedMotion kRide{10.0, 1e-8, 5.0};

TEST(StiffRun, IsOneWhoseStepsAreShortForAModeThatHasDiedAway) {
  // h = 0.909 ms, |h lambda| = 3.0: three quarters of the mode a step.
  const std::optional<StiffRun> stiff = stiffRun(ofSteps(11'000), kRide, kStiffModes);
  ASSERT_TRUE(stiff.has_value());
  EXPECT_EQ(stiff->eigenvalue, kStiffModes[0]);
  EXPECT_DOUBLE_EQ(stiff->step, 10.0 / 11'000);
  // (6.08 h)^6 / 3600 = 1e-8; that the first term is not all of the error makes 1 % of the step.
  EXPECT_WITHIN(stiff->needed, std::pow(3600e-8, 1.0 / 6.0) / std::abs(kStiffModes[1]), 0.01 * stiff->needed);
}

TEST(StiffRun, IsNoneThatFollowsItsFastestMode) {
  // h = 31 us, |h lambda| = 0.10: 3e-10 of the mode a step.
  EXPECT_FALSE(stiffRun(ofSteps(320'000), kRide, kStiffModes).has_value());
}

TEST(StiffRun, IsNoneWithoutAFastMode) {
  EXPECT_FALSE(stiffRun(ofSteps(11'000), kRide, std::span(kStiffModes).subspan(1)).has_value());
}

TEST(StiffRun, IsNoneWhoseInputAsksForTheSteps) {
  FollowedMotion corrugation = kRide;
  corrugation.fastest_input = 150.0;  // 1.2 ms are needed, 0.9 are taken
  EXPECT_FALSE(stiffRun(ofSteps(11'000), corrugation, kStiffModes).has_value());
}

TEST(StiffRun, IsNoneOfFewSteps) {
  FollowedMotion shorter = kRide;
  shorter.duration = 0.8;
  EXPECT_FALSE(stiffRun(ofSteps(900), shorter, kStiffModes).has_value());
}

std::string noteOf(const Vehicle& vehicle, const std::string& form, const std::string& method,
                   double relative = 1e-10) {
  Scenario scenario = test::paperScenario(History::kExtended);
  scenario.run.duration = 2.0;
  RunChoice choice;
  choice.form = form;
  choice.method = method;
  choice.relative = relative;
  return stiffnessNote(compile(vehicle, scenario.gravity), scenario, choice, simulate(vehicle, scenario, choice));
}

/// One body on a wheelset whose contact is damped far beyond critically: that motion dies away within 30 us, and no
/// wave of the rail keeps it up.
Vehicle stiffVehicle() {
  Vehicle vehicle;
  vehicle.name = "stiff";
  vehicle.elements = {test::element("primary", 3040e3, 30e3)};
  vehicle.bodies = {test::body("frame", 9e3, 0.0, std::nullopt, {Motion::kZ})};
  Wheelset axle = test::wheelset("axle", 0.0);
  axle.mass = 1500.0;
  axle.contact_stiffness = 2.4e9;
  axle.contact_damping = 5e7;
  vehicle.wheelsets = {axle};
  vehicle.suspensions = {test::suspension("spring", "primary", "frame", "axle", 0.0)};
  return vehicle;
}

TEST(StiffnessNote, OfAStiffRunNamesItsStepsAndTheRemedyInOneLine) {
  for (const double relative : {1e-5, 1e-8, 1e-10}) {
    const std::string note = noteOf(stiffVehicle(), "matrix", "dopri5", relative);
    EXPECT_EQ(note.rfind("dopri5 took ", 0), 0u) << relative << note;
    EXPECT_NE(note.find(": a mode of 3.33e+04 1/s that has died away keeps them short; take --method exact"),
              std::string::npos)
        << note;
    EXPECT_EQ(note.find('\n'), std::string::npos);
  }
  const std::string nonlinear = noteOf(stiffVehicle(), "mbs", "dopri5", 1e-5);
  EXPECT_NE(nonlinear.find("an implicit method would take long ones"), std::string::npos) << nonlinear;
}

TEST(StiffnessNote, IsEmptyForVehiclesThatAreNotStiffAtAnyTolerance) {
  for (const double relative : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    EXPECT_EQ(noteOf(test::paperVehicle(), "flat", "dopri5", relative), "") << relative;
    EXPECT_EQ(noteOf(test::asymmetricBogiePitchVehicle(), "matrix", "dopri5", relative), "") << relative;
  }
}

TEST(StiffnessNote, IsEmptyForOtherMethods) { EXPECT_EQ(noteOf(stiffVehicle(), "matrix", "exact"), ""); }

}  // namespace
}  // namespace vehicle
