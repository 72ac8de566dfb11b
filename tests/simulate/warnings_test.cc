// What no railway could do is said, and nothing else.

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "libvehicle/simulate/run_warnings.h"
#include "libvehicle/simulate/vehicle_warnings.h"
#include "tests/simulate/histories.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

constexpr double kGravity = 9.81;

Warnings atRest(const Vehicle& vehicle, double gravity = kGravity) { return restWarnings(compile(vehicle, gravity)); }

std::set<WarningCode> codesOf(const Warnings& warnings) {
  std::set<WarningCode> codes;
  for (const Warning& each : warnings) codes.insert(each.code);
  return codes;
}

using Codes = std::set<WarningCode>;

/// A wagon on two springs `half` metres ahead of and behind its centre of gravity, which is `height` metres above them.
Vehicle tallWagon(double stiffness, double half, double height) {
  Vehicle made;
  made.name = "wagon";
  made.elements = {element("leaf", stiffness, 1e3)};
  made.bodies = {body("wagon", 10e3, 0.0, 5e3, {Motion::kZ, Motion::kPitch})};
  made.bodies[0].z = 0.5 + height;
  made.wheelsets = {wheelset("w1", half), wheelset("w2", -half)};
  made.suspensions = {suspension("s1", "leaf", "wagon", "w1", half), suspension("s2", "leaf", "wagon", "w2", -half)};
  for (Wheelset& each : made.wheelsets) each.z = 0.45;
  for (Suspension& each : made.suspensions) each.z_upper = each.z_lower = 0.5;
  return made;
}

TEST(RestWarnings, OfVehiclesThatStandThereAreNone) {
  for (const Vehicle& vehicle : {paperVehicle(), bogiePitchVehicle(), contactVehicle(), hertzVehicle(),
                                 asymmetricBogiePitchVehicle(), heightsVehicle(), bogiePitchHeightsVehicle()}) {
    EXPECT_EQ(codesOf(atRest(vehicle)), Codes{}) << vehicle.name;
  }
}

// Pitch stiffness 2 k a^2 - m g h changes its sign at h = 2 k a^2 / (m g).
TEST(RestWarnings, AVehicleTipsOverWhereItsPitchStiffnessIsNegative) {
  const double k = 100e3, a = 0.5, limit = 2.0 * k * a * a / (10e3 * kGravity);
  EXPECT_EQ(codesOf(atRest(tallWagon(k, a, 0.999 * limit))), Codes{});
  const Warnings warnings = atRest(tallWagon(k, a, 2.5));
  ASSERT_EQ(codesOf(warnings), Codes{WarningCode::kCannotStand});
  EXPECT_EQ(warnings[0].subject, "wagon pitch");
  // sqrt((m g h - 2 k a^2) / J), one rounding of an eigenvalue
  EXPECT_WITHIN(*warnings[0].value, std::sqrt((10e3 * kGravity * 2.5 - 2.0 * k * a * a) / 5e3), 1e-12);
  EXPECT_EQ(codesOf(atRest(tallWagon(k, a, 2.5), 0.0)), Codes{}) << "without gravity nothing tips";
}

TEST(RestWarnings, AMotionThatNothingHoldsIsFree) {
  Vehicle vehicle = bogiePitchVehicle();
  for (Suspension& each : vehicle.suspensions) {
    if (each.upper == "front_bogie") each.x = 9.5;
  }
  const Warnings warnings = atRest(vehicle);
  ASSERT_EQ(codesOf(warnings), Codes{WarningCode::kFreeMode});
  EXPECT_EQ(warnings[0].subject, "front_bogie pitch");
}

TEST(RestWarnings, GivenLoadsHaveToCarryTheWeight) {
  Vehicle vehicle = paperVehicle();
  const double weight = 75e3 * kGravity;
  for (Wheelset& each : vehicle.wheelsets) each.load = 0.25 * weight;
  EXPECT_EQ(codesOf(atRest(vehicle)), Codes{});
  for (Wheelset& each : vehicle.wheelsets) each.load = 0.996 * 0.25 * weight;  // rounded on a data sheet
  EXPECT_EQ(codesOf(atRest(vehicle)), Codes{});
  for (Wheelset& each : vehicle.wheelsets) each.load = 0.9 * 0.25 * weight;
  const Warnings warnings = atRest(vehicle);
  ASSERT_EQ(codesOf(warnings), Codes{WarningCode::kGivenLoads});
  EXPECT_WITHIN(*warnings[0].value, -0.1 * weight, 1e-9 * weight);
}

TEST(RestWarnings, ASpringThatComesDownByMoreThanHalfAMetreIsNamed) {
  Vehicle vehicle = paperVehicle();
  vehicle.elements[1].stiffness_z = 57e3 * kGravity / 2.0 / 0.51;
  const Warnings warnings = atRest(vehicle);
  ASSERT_EQ(warnings.size(), 2u);  // front and rear
  EXPECT_EQ(warnings[0].code, WarningCode::kRestDeflection);
  EXPECT_EQ(warnings[0].subject, "secondary_front");
  EXPECT_WITHIN(*warnings[0].value, 0.51, 1e-12);
  vehicle.elements[1].stiffness_z *= 0.51 / 0.49;
  EXPECT_EQ(codesOf(atRest(vehicle)), Codes{});
}

TEST(MotionWarnings, SayWhatGrowsAndWhatRoundingShows) {
  EXPECT_TRUE(motionWarnings(MotionRates(Eigen::MatrixXd{{0.0, 1.0}, {-25.0, -0.1}}), true).empty());
  const Eigen::MatrixXd growing{{0.0, 1.0}, {-25.0, 0.1}};
  EXPECT_EQ(codesOf(motionWarnings(MotionRates(growing), true)), Codes{WarningCode::kUnstableMode});
  EXPECT_TRUE(motionWarnings(MotionRates(growing), false).empty()) << "CANNOT_STAND says more";
  Vehicle vehicle = paperVehicle();
  vehicle.elements[1].damping_z = 1e20;
  EXPECT_TRUE(
      codesOf(simulate(vehicle, paperScenario(History::kOnset)).warnings).contains(WarningCode::kIllConditioned));
}

TEST(RangeWarnings, AWheelThatPullsAtTheRailIsNamedWithLoadAndTime) {
  Scenario scenario = paperScenario(History::kOnset);
  scenario.track->harmonics = {harmonic(25.0, 1.0, 200e-3)};
  const RunResult result = simulate(paperVehicle(), scenario);
  ASSERT_TRUE(codesOf(result.warnings).contains(WarningCode::kWheelLoad));
  const Warning& worst = result.warnings.front();
  EXPECT_EQ(worst.code, WarningCode::kWheelLoad);
  double lowest = 0.0;
  for (std::size_t i = 0; i < result.summaries.size(); ++i) {
    if (result.history.columns()[i + 1].name.ends_with(".load")) lowest = std::min(lowest, result.summaries[i].lowest);
  }
  EXPECT_EQ(*worst.value, lowest) << "the worst comes first";
  EXPECT_EQ(worst.unit, "N");
  EXPECT_TRUE(worst.time);
  Scenario weightless = scenario;
  weightless.gravity = 0.0;
  EXPECT_FALSE(codesOf(simulate(paperVehicle(), weightless).warnings).contains(WarningCode::kWheelLoad));
}

TEST(RangeWarnings, OfAnOrdinaryRunThereAreNone) {
  for (const History history : {History::kOnset, History::kExtended}) {
    for (const Vehicle& vehicle : {paperVehicle(), bogiePitchVehicle(), asymmetricVehicle(), heightsVehicle()}) {
      EXPECT_TRUE(simulate(vehicle, paperScenario(history)).warnings.empty()) << vehicle.name;
    }
  }
}

TEST(RangeWarnings, AMotionBeyondLinearKinematicsIsNamed) {
  Scenario scenario = paperScenario(History::kExtended);
  scenario.track->harmonics = {harmonic(25.0, 1.0, 0.8)};
  const Codes codes = codesOf(simulate(paperVehicle(), scenario).warnings);
  EXPECT_TRUE(codes.contains(WarningCode::kLargeMotion));
}

TEST(RangeWarnings, AVehicleThatTipsOverIsSaidToBeforeAndAfter) {
  Scenario scenario = paperScenario(History::kExtended);
  const RunResult result = simulate(tallWagon(100e3, 0.5, 2.5), scenario);
  EXPECT_TRUE(codesOf(result.warnings).contains(WarningCode::kCannotStand));
  EXPECT_TRUE(codesOf(result.warnings).contains(WarningCode::kLargeMotion));
  EXPECT_FALSE(codesOf(result.warnings).contains(WarningCode::kUnstableMode));
}

}  // namespace
}  // namespace vehicle::test
