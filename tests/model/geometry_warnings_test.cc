#include "libvehicle/model/geometry_warnings.h"

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/definition/train.h"
#include "tests/support/trains.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]

std::string warningsOf(const Vehicle& vehicle) {
  const Topology topology = topologyOf(vehicle);
  std::string text;
  for (const Warning& each : geometryWarnings(vehicle, topology, restOf(topology, kGravity)))
    text += each.text() + '\n';
  return text;
}

std::string warningsAfter(const std::function<void(Vehicle&)>& change) {
  Vehicle made = bogiePitchVehicle();
  change(made);
  return warningsOf(made);
}

TEST(GeometryWarnings, AreNotGivenForUsualVehicles) {
  for (const Vehicle& each : {paperVehicle(), asymmetricVehicle(), bogiePitchVehicle(), asymmetricBogiePitchVehicle(),
                              contactVehicle(), hertzVehicle(), heightsVehicle(), bogiePitchHeightsVehicle()}) {
    EXPECT_EQ(warningsOf(each), "") << each.name;
  }
}

TEST(FreePitch, IsThatOfABodyWhoseSpringsStandAtOnePlace) {
  const auto bothPrimariesAt = [](double x) {
    return [x](Vehicle& made) {
      named(made.suspensions, "primary_1").x = x;
      named(made.suspensions, "primary_2").x = x;
    };
  };
  const std::string bogie =
      "warning: front_bogie: may pitch, but all its springs stand at x = 9.5 m and nothing resists; give each spring "
      "its "
      "x, or leave pitch out of its motion [FREE_PITCH]\n";
  EXPECT_EQ(warningsAfter(bothPrimariesAt(9.5)).substr(0, bogie.size()), bogie);
  // One primary apart from the others is enough.
  EXPECT_EQ(warningsAfter([](Vehicle& made) { named(made.suspensions, "primary_1").x = 9.5; }).find("FREE_PITCH"),
            std::string::npos);
  // A bogie that does not pitch has nothing to resist.
  EXPECT_EQ(warningsAfter([&](Vehicle& made) {
              bothPrimariesAt(9.5)(made);
              named(made.bodies, "front_bogie").motion = {Motion::kZ};
            }).find("FREE_PITCH"),
            std::string::npos);
}

/// A body on one spring, which takes hold of it `above` metres over its centre of gravity.
Vehicle onOneSpring(double above) {
  Vehicle made;
  made.name = "one";
  made.elements = {element("spring", 1e6, 1e3)};
  made.bodies = {body("deck", 1e3, 0.0, 1e3, {Motion::kZ, Motion::kPitch})};
  made.bodies[0].z = 1.0;
  made.wheelsets = {wheelset("axle", 0.0)};
  made.suspensions = {suspension("spring_1", "spring", "deck", "axle", 0.0)};
  made.suspensions[0].z_upper = 1.0 + above;
  made.suspensions[0].z_lower = 0.5;
  return made;
}

// F0 z_a: a body that hangs on its spring is a pendulum and comes back; one that stands on it does not.
TEST(FreePitch, IsHeldByGravityWhereTheBodyHangs) {
  EXPECT_EQ(warningsOf(onOneSpring(0.4)), "");
  EXPECT_NE(warningsOf(onOneSpring(0.0)).find("FREE_PITCH"), std::string::npos);
  EXPECT_NE(warningsOf(onOneSpring(-0.4)).find("FREE_PITCH"), std::string::npos);
}

TEST(FreePitch, OfABodyWithoutBounceIsHeldByASpringBesideItsCentre) {
  const auto withSpringAt = [](double x) {
    Vehicle made = onOneSpring(0.0);
    made.bodies[0].motion = {Motion::kPitch};
    made.suspensions[0].x = made.wheelsets[0].x = x;
    made.suspensions[0].preload = 0.0;
    return warningsOf(made);
  };
  EXPECT_EQ(withSpringAt(0.5), "");
  EXPECT_NE(withSpringAt(0.0).find("FREE_PITCH"), std::string::npos);
}

TEST(FarFromWheelset, IsASuspensionMetresFromWhereItStands) {
  EXPECT_EQ(warningsAfter([](Vehicle& made) { named(made.suspensions, "primary_1").x -= 0.6; }), "");
  EXPECT_EQ(
      warningsAfter([](Vehicle& made) { named(made.suspensions, "primary_1").x = 9.5; }),
      "warning: primary_1: stands at x = 9.5 m, 1.28 m from its wheelset \"wheelset_1\" at x = 10.78 m; give it the "
      "x of the wheelset [FAR_FROM_WHEELSET]\n");
}

TEST(SamePlace, IsThatOfTwoAxlesCloserThanAWheel) {
  const auto secondAxleAt = [](double x) {
    return warningsAfter([x](Vehicle& made) { named(made.wheelsets, "wheelset_2").x = x; });
  };
  EXPECT_NE(
      secondAxleAt(10.78).find(
          "warning: wheelset_2: stands where \"wheelset_1\" stands, at x = 10.78 m; wheels of two axles need more "
          "room; give each axle its own x [SAME_PLACE]\n"),
      std::string::npos);
  EXPECT_NE(secondAxleAt(10.6).find("wheelset_2: stands 0.18 m from where \"wheelset_1\""), std::string::npos);
  EXPECT_EQ(secondAxleAt(10.4).find("SAME_PLACE"), std::string::npos);
}

TEST(WarningPlace, IsThatOfThePartInItsFile) {
  Vehicle made = bogiePitchVehicle();
  named(made.suspensions, "primary_1").x = 9.5;
  named(made.suspensions, "primary_1").origin = {{"coach.xml", 17}};
  EXPECT_EQ(warningsOf(made).substr(0, 23), "coach.xml:17: warning: ");
}

Vehicle trainOf(double spacing, int count, std::optional<double> end_x) {
  Train train;
  train.name = "train";
  TrainVehicle coaches;
  coaches.vehicle = bogiePitchVehicle();
  int line = 1;
  for (Wheelset& each : coaches.vehicle.wheelsets) each.origin = {{"coach.xml", ++line}};
  coaches.count = count;
  coaches.spacing = spacing;
  coaches.origin = {{"train.xml", 2}};
  train.vehicles = {coaches};
  if (end_x) {
    Coupling coupling;
    coupling.stiffness_z = 50e3;
    coupling.end_x = end_x;
    train.couplings = {coupling};
  }
  return assembled(train);
}

// Axles at +-10.78 m: a coach takes at least 21.56 m of the track.
TEST(Overlap, IsThatOfVehiclesWhoseAxlesReachIntoEachOther) {
  EXPECT_EQ(warningsOf(trainOf(26.0, 3, std::nullopt)), "");
  EXPECT_EQ(warningsOf(trainOf(22.0, 3, std::nullopt)), "");
  EXPECT_EQ(warningsOf(trainOf(20.0, 5, std::nullopt)),
            "train.xml:2: warning: manchester-coach_2: stands 1.56 m deep in \"manchester-coach_1\", which ends at x = "
            "-10.78 m; take a larger spacing [OVERLAP]\n");
  // Coupled ends are the ends of a vehicle; check() refuses those that overlap.
  EXPECT_EQ(warningsOf(trainOf(26.0, 3, 12.5)), "");
}

TEST(SamePlace, AcrossATrainIsReportedOncePerPlaceOfTheFiles) {
  const std::string text = warningsOf(trainOf(21.56, 4, std::nullopt));
  EXPECT_EQ(
      text,
      "coach.xml:5: warning: manchester-coach_1.wheelset_4: stands where \"manchester-coach_2.wheelset_1\" stands, at "
      "x = -10.78 m; wheels of two axles need more room; give each axle its own x [SAME_PLACE]\n");
}

}  // namespace
}  // namespace vehicle::test
