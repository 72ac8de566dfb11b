// The loaded rest position against closed forms and against equilibrium.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/definition/train.h"
#include "libvehicle/model/rest.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]
// Rounding of a 10 x 10 solve with one refinement, and of the sums of the check: some dozen units of 1e-16.
constexpr double kRounding = 1e-13;

std::vector<Vehicle> allVehicles() {
  return {paperVehicle(),   asymmetricVehicle(), bogiePitchVehicle(), asymmetricBogiePitchVehicle(),
          contactVehicle(), hertzVehicle(),      heightsVehicle(),    bogiePitchHeightsVehicle()};
}

std::size_t placeOf(const Topology& topology, const std::string& suspension) {
  for (std::size_t s = 0; s < topology.suspensions.size(); ++s) {
    if (topology.suspensions[s].name == suspension) return s;
  }
  throw std::invalid_argument("no suspension " + suspension);
}

double loadOf(const Topology& topology, const Rest& rest, const std::string& suspension) {
  return rest.suspension_load[placeOf(topology, suspension)];
}

std::string messageOf(const Vehicle& vehicle, double gravity = kGravity) {
  try {
    static_cast<void>(restOf(topologyOf(vehicle), gravity));
  } catch (const InvalidInput& wrong) {
    return wrong.what();
  }
  return "";
}

// The numbers of the documentation, to their last digit (half a micrometre).
TEST(PaperVehicleAtRest, HasComeDownAsDocumented) {
  const Rest rest = restOf(topologyOf(paperVehicle()), kGravity);
  EXPECT_WITHIN(rest.coordinates[0], -165.613e-3, 0.5e-6);
  EXPECT_WITHIN(rest.coordinates[2], -60.506e-3, 0.5e-6);
  EXPECT_WITHIN(rest.coordinates[3], -60.506e-3, 0.5e-6);
  // Mirror symmetry: no pitch but rounding of 0.1 m over 3.7 m.
  EXPECT_WITHIN(rest.coordinates[1], 0.0, 1e-16);
}

// Closed form: each spring in turn carries what stands above it.
TEST(PaperVehicleAtRest, DeflectsByWeightOverStiffness) {
  const Rest rest = restOf(topologyOf(paperVehicle()), kGravity);
  const double bogie = -(9e3 + 28.5e3) * kGravity / (2 * 3040e3);
  EXPECT_WITHIN(rest.coordinates[2], bogie, kRounding * 0.06);
  EXPECT_WITHIN(rest.coordinates[0], bogie - 28.5e3 * kGravity / 2660e3, kRounding * 0.17);
}

TEST(Rest, BalancesForcesAndMomentsOnEveryBody) {
  for (const Vehicle& vehicle : allVehicles()) {
    const Topology topology = topologyOf(vehicle);
    const Rest rest = restOf(topology, kGravity);
    for (std::size_t b = 0; b < topology.bodies.size(); ++b) {
      const TopologyBody& body = topology.bodies[b];
      double force = -body.mass * kGravity;
      double moment = 0.0;
      double size = body.mass * kGravity;
      for (std::size_t s = 0; s < topology.suspensions.size(); ++s) {
        const TopologySuspension& suspension = topology.suspensions[s];
        const double load = rest.suspension_load[s];
        if (suspension.upper == static_cast<int>(b)) {
          force += load;
          moment += load * suspension.arm_upper;
        }
        if (suspension.lower_body == static_cast<int>(b)) {
          force -= load;
          moment -= load * suspension.arm_lower;
        }
        size = std::max(size, load);
      }
      EXPECT_WITHIN(force, 0.0, kRounding * size) << vehicle.name << ' ' << body.name;
      if (body.pitch_index < 0) continue;
      EXPECT_WITHIN(moment, 0.0, kRounding * size * 10.0) << vehicle.name << ' ' << body.name;
    }
  }
}

TEST(WheelLoads, SumToTheTotalWeight) {
  for (const Vehicle& vehicle : allVehicles()) {
    const Topology topology = topologyOf(vehicle);
    const Rest rest = restOf(topology, kGravity);
    double weight = 0.0;
    double carried = 0.0;
    for (const TopologyBody& body : topology.bodies) weight += body.mass * kGravity;
    for (const TopologyWheelset& wheelset : topology.wheelsets) weight += wheelset.mass * kGravity;
    for (const double load : rest.wheel_load) carried += load;
    EXPECT_WITHIN(carried, weight, kRounding * weight) << vehicle.name;
  }
}

// Carbody's CG at 2.3 m, pivots at 6.0 and -2.5 m.
TEST(UnequalPivots, ShareTheCarbodyByTheLeverRule) {
  const Topology topology = topologyOf(asymmetricVehicle());
  const Rest rest = restOf(topology, kGravity);
  const double weight = 48e3 * kGravity;
  EXPECT_WITHIN(loadOf(topology, rest, "secondary_front"), weight * 4.8 / 8.5, kRounding * weight);
  EXPECT_WITHIN(loadOf(topology, rest, "secondary_rear"), weight * 3.7 / 8.5, kRounding * weight);
}

TEST(TwoAxlesUnderABogieThatDoesNotPitch, DeflectEqually) {
  const Topology topology = topologyOf(asymmetricVehicle());
  const Rest rest = restOf(topology, kGravity);
  const double front = 48e3 * kGravity * 4.8 / 8.5 + 10.2e3 * kGravity;
  EXPECT_WITHIN(loadOf(topology, rest, "primary_1"), front * 2.7 / 6.1, kRounding * front);
  EXPECT_WITHIN(loadOf(topology, rest, "primary_2"), front * 3.4 / 6.1, kRounding * front);
}

TEST(Preload, StaysAsGivenAndTheOthersCarryTheRest) {
  Vehicle vehicle = paperVehicle();
  named(vehicle.suspensions, "primary_1").preload = 150e3;
  const Topology topology = topologyOf(vehicle);
  const Rest rest = restOf(topology, kGravity);
  const double bogie = 37.5e3 * kGravity;
  EXPECT_EQ(loadOf(topology, rest, "primary_1"), 150e3);
  EXPECT_WITHIN(loadOf(topology, rest, "primary_2"), bogie - 150e3, kRounding * bogie);
  EXPECT_WITHIN(loadOf(topology, rest, "primary_3"), bogie / 2, kRounding * bogie);
  EXPECT_WITHIN(rest.wheel_load[0], 150e3, 0.0);
}

TEST(Preload, OfEverySpringIsAcceptedWhereItBalances) {
  Vehicle vehicle = paperVehicle();
  for (Suspension& each : vehicle.suspensions) {
    each.preload = each.lower.find("bogie") != std::string::npos ? 28.5e3 * kGravity : 18.75e3 * kGravity;
  }
  const Rest rest = restOf(topologyOf(vehicle), kGravity);
  EXPECT_EQ(rest.coordinates, std::vector<double>(4, 0.0));
}

TEST(WheelLoad, GivenReplacesTheComputedOne) {
  Vehicle vehicle = paperVehicle();
  vehicle.wheelsets[2].load = 181e3;
  const Rest rest = restOf(topologyOf(vehicle), kGravity);
  EXPECT_EQ(rest.wheel_load[2], 181e3);
  EXPECT_WITHIN(rest.wheel_load[3], 18.75e3 * kGravity, kRounding * 18.75e3 * kGravity);
}

TEST(RestWithoutGravity, IsTheUnloadedPosition) {
  for (const Vehicle& vehicle : {paperVehicle(), heightsVehicle(), contactVehicle()}) {
    const Rest rest = restOf(topologyOf(vehicle), 0.0);
    for (const double each : rest.coordinates) EXPECT_EQ(each, 0.0);
    for (const double each : rest.suspension_load) EXPECT_EQ(each, 0.0);
    for (const double each : rest.wheel_load) EXPECT_EQ(each, 0.0);
    for (const double each : rest.pitch_stiffness) EXPECT_EQ(each, 0.0);
  }
}

TEST(HertzContact, ComesDownByTheThreeHalvesLawAndIsLinearisedThere) {
  const Topology topology = topologyOf(hertzVehicle());
  const Rest rest = restOf(topology, kGravity);
  const double load = (32e3 / 4 + 2615.0 / 2 + 1813.0) * kGravity;
  for (std::size_t j = 0; j < 4; ++j) {
    EXPECT_WITHIN(rest.wheel_load[j], load, kRounding * load);
    const double delta = std::pow(load / 200e9, 2.0 / 3.0);
    EXPECT_WITHIN(rest.coordinates[static_cast<std::size_t>(topology.wheelsets[j].z_index)], -delta, 1e-12 * delta);
    // d(C delta^1.5)/d delta at the static compression.
    const double slope = 1.5 * 200e9 * std::sqrt(delta);
    EXPECT_WITHIN(rest.contact_stiffness[j], slope, 1e-12 * slope);
  }
}

// Statically indeterminate: a bogie that does not pitch on two axles whose contacts differ. Both legs must come
// down by the same, spring and contact together: F1/c + (F1/C1)^(2/3) = F2/c + (F2/C2)^(2/3).
TEST(HertzContact, SharesALoadSoThatBothLegsDeflectEqually) {
  Vehicle vehicle;
  vehicle.name = "two-legs";
  vehicle.elements = {element("spring", 300e6, 0.0)};
  vehicle.bodies = {body("frame", 20e3, 0.0, std::nullopt, {Motion::kZ})};
  vehicle.wheelsets = {wheelset("ahead", 1.0), wheelset("behind", -1.0)};
  vehicle.wheelsets[0].hertz_constant = 200e9;
  vehicle.wheelsets[1].hertz_constant = 3e9;
  for (Wheelset& each : vehicle.wheelsets) each.mass = 1e3;
  vehicle.suspensions = {suspension("s_ahead", "spring", "frame", "ahead", 1.0),
                         suspension("s_behind", "spring", "frame", "behind", -1.0)};
  const Rest rest = restOf(topologyOf(vehicle), kGravity);
  EXPECT_GT(rest.suspension_load[0], 1.2 * rest.suspension_load[1]);
  const auto legDeflection = [&](std::size_t leg, double hertz) {
    return rest.suspension_load[leg] / 300e6 + std::pow(rest.wheel_load[leg] / hertz, 2.0 / 3.0);
  };
  // The fixed-point loop ends when loads change by 1e-15 of the weight.
  EXPECT_WITHIN(legDeflection(0, 200e9), legDeflection(1, 3e9), 1e-12 * legDeflection(0, 200e9));
  EXPECT_WITHIN(-rest.coordinates[0], legDeflection(0, 200e9), 1e-12 * legDeflection(0, 200e9));
}

TEST(HertzContact, TakesAGivenLoadForItsStiffness) {
  Vehicle vehicle = hertzVehicle();
  vehicle.wheelsets[1].load = 120e3;
  const Rest rest = restOf(topologyOf(vehicle), kGravity);
  const double stiffness = 1.5 * std::pow(200e9, 2.0 / 3.0) * std::pow(120e3, 1.0 / 3.0);
  EXPECT_WITHIN(rest.contact_stiffness[1], stiffness, kRounding * stiffness);
}

// Below the CG by h, a vertical push at the attachments is -mk g h: it tips the carbody over.
TEST(StaticLoads, AtAttachmentsBelowTheCentreOfGravityDestabilise) {
  const Rest rest = restOf(topologyOf(heightsVehicle(0.5)), kGravity);
  const double expected = -57e3 * kGravity * 0.5;
  EXPECT_WITHIN(rest.pitch_stiffness[0], expected, kRounding * std::abs(expected));
}

// A bogie feels the carbody's load too: its primaries push up with (m + mk/2) g, its secondary down with mk g / 2,
// all at h below its CG: the rest is -m g h.
TEST(StaticLoads, OfABogieIncludeWhatStandsOnIt) {
  Vehicle vehicle = bogiePitchHeightsVehicle(0.3);
  Rest rest = restOf(topologyOf(vehicle), kGravity);
  const double same_height = -2615.0 * kGravity * 0.3;
  EXPECT_WITHIN(rest.pitch_stiffness[1], same_height, kRounding * 16e3 * kGravity);
  // The secondary raised to 0.2 m above the bogie's CG: its downward load there destabilises further.
  named(vehicle.suspensions, "secondary_front").z_lower = 0.95 + 0.2;
  rest = restOf(topologyOf(vehicle), kGravity);
  const double raised = -(16e3 + 2615.0) * kGravity * 0.3 - 16e3 * kGravity * 0.2;
  EXPECT_WITHIN(rest.pitch_stiffness[1], raised, kRounding * 16e3 * kGravity);
}

TEST(StaticLoads, WithoutHeightsLeavePitchAlone) {
  const Rest rest = restOf(topologyOf(bogiePitchVehicle()), kGravity);
  EXPECT_EQ(rest.pitch_stiffness, std::vector<double>(3, 0.0));
}

TEST(ContactStiffness, IsTheGivenOneOrZeroOnTheRail) {
  EXPECT_EQ(restOf(topologyOf(contactVehicle()), kGravity).contact_stiffness, std::vector<double>(4, 2.4e9));
  EXPECT_EQ(restOf(topologyOf(bogiePitchVehicle()), kGravity).contact_stiffness, std::vector<double>(4, 0.0));
}

TEST(PreloadsThatDoNotBalance, AreRefusedNamingTheBody) {
  Vehicle vehicle = paperVehicle();
  named(vehicle.suspensions, "secondary_front").preload = 200e3;
  named(vehicle.suspensions, "secondary_rear").preload = 200e3;
  EXPECT_EQ(messageOf(vehicle),
            "error: <vehicle><body name=\"carbody\">: springs and preloads leave a vertical force of -159170 N at "
            "rest; "
            "the weight must be carried; give the springs under it a stiffness, or leave out one of the preloads\n");
}

TEST(UnbalancedMoment, IsRefusedNamingTheBody) {
  Vehicle vehicle = paperVehicle();
  named(vehicle.suspensions, "secondary_front").preload = 28.5e3 * kGravity + 1e3;
  named(vehicle.suspensions, "secondary_rear").preload = 28.5e3 * kGravity - 1e3;
  EXPECT_EQ(messageOf(vehicle),
            "error: <vehicle><body name=\"carbody\">: springs and preloads leave a pitch moment of 7450 N m at rest; "
            "moments must balance; give the springs under it a stiffness, or leave out one of the preloads\n");
}

// A spring at the end of a long lever that carries nothing: rounding of weight * length is all that is left of its moment.
TEST(Balance, WithinTheRoundingOfWeightTimesLengthIsBalance) {
  for (const double scale : {1e-3, 1.0, 1e3}) {
    Vehicle vehicle = bogiePitchVehicle();
    for (Body& each : vehicle.bodies) each.mass *= scale;
    for (Element& each : vehicle.elements) each.stiffness_z *= scale;
    for (const char* primary : {"primary_1", "primary_3"}) {
      named(vehicle.suspensions, primary).x = primary == std::string("primary_1") ? 9.5 : -9.5;
    }
    EXPECT_EQ(messageOf(vehicle), "") << scale;
    const Rest rest = restOf(topologyOf(vehicle), kGravity);
    // The spring under the pivot carries all: half the carbody and the bogie.
    const double load = scale * (16e3 + 2615.0) * kGravity;
    EXPECT_WITHIN(loadOf(topologyOf(vehicle), rest, "primary_1"), load, 1e-9 * load);
    EXPECT_WITHIN(loadOf(topologyOf(vehicle), rest, "primary_2"), 0.0, 1e-9 * load);
  }
  // A moment a million times that is still refused: 1 N m on a weight of 319 kN.
  Vehicle vehicle = bogiePitchVehicle();
  named(vehicle.suspensions, "secondary_front").preload = 16e3 * kGravity;
  named(vehicle.suspensions, "secondary_rear").preload = 16e3 * kGravity;
  EXPECT_EQ(messageOf(vehicle), "");
  named(vehicle.suspensions, "secondary_front").preload = 16e3 * kGravity + 1.0;
  EXPECT_NE(messageOf(vehicle), "");
}

// One preload that is mistyped leaves its force on both its ends: one mistake, at the suspension that has it.
TEST(PreloadsThatDoNotBalance, AreOneProblemWhereOneOfThemExplainsBothBodies) {
  Vehicle vehicle = paperVehicle();
  vehicle.bodies[0].motion = {Motion::kZ};
  for (Suspension& each : vehicle.suspensions) {
    const bool secondary = each.name.starts_with("secondary");
    each.preload = (secondary ? 28.5e3 : 0.5 * (28.5e3 + 9e3)) * kGravity;
  }
  EXPECT_EQ(messageOf(vehicle), "");
  Suspension& wrong = named(vehicle.suspensions, "secondary_front");
  wrong.preload = *wrong.preload + 20e3;
  EXPECT_EQ(
      messageOf(vehicle),
      "error: <vehicle><suspension name=\"secondary_front\">: preload=\"299585 N\" leaves a vertical force of "
      "20000 N on \"carbody\" and the opposite on \"front_bogie\"; the weight must be carried; a preload of 279585 N "
      "balances both, or leave it out\n");
}

TEST(CentreOfGravityBeyondTheWheels, IsRefusedNamingTheLiftedWheelset) {
  Vehicle vehicle;
  vehicle.name = "trolley";
  vehicle.elements = {element("spring", 1e6, 0.0)};
  vehicle.bodies = {body("deck", 1e3, 3.0, 1e3, {Motion::kZ, Motion::kPitch})};
  vehicle.wheelsets = {wheelset("ahead", 2.0), wheelset("behind", -2.0)};
  vehicle.suspensions = {suspension("s_ahead", "spring", "deck", "ahead", 2.0),
                         suspension("s_behind", "spring", "deck", "behind", -2.0)};
  EXPECT_EQ(messageOf(vehicle),
            "error: <vehicle><wheelset name=\"behind\">: its static wheel load would be -2452.5 N; a rail can only "
            "push; "
            "move the centre of gravity between the wheelsets, or give its load\n");
}

// The places of the parts in their file, and of equal vehicles of a train one.
TEST(RestProblems, HaveFileAndLine) {
  Vehicle vehicle = paperVehicle();
  vehicle.bodies[0].origin = {{"coach.xml", 7}};
  named(vehicle.suspensions, "secondary_front").preload = 200e3;
  named(vehicle.suspensions, "secondary_rear").preload = 200e3;
  EXPECT_EQ(messageOf(vehicle).substr(0, 20), "coach.xml:7: error: ");
  Train train;
  train.name = "train";
  train.vehicles.resize(1);
  train.vehicles[0].vehicle = vehicle;
  train.vehicles[0].count = 5;
  train.vehicles[0].spacing = 20.0;
  try {
    static_cast<void>(restOf(topologyOf(assembled(train)), kGravity));
    ADD_FAILURE() << "accepted";
  } catch (const InvalidInput& wrong) {
    ASSERT_EQ(wrong.problems().size(), 1u);
    EXPECT_EQ(wrong.problems()[0].text().substr(0, 20), "coach.xml:7: error: ");
  }
}

TEST(HertzContactWithoutLoad, IsRefusedWithTheRemedy) {
  Vehicle vehicle = hertzVehicle();
  for (std::size_t j = 1; j < 4; ++j) vehicle.wheelsets[j].load = 100e3;
  EXPECT_EQ(messageOf(vehicle, 0.0),
            "error: <vehicle><wheelset name=\"wheelset_1\">: a Hertz contact without static load has no stiffness; "
            "set gravity > 0, or give its load or contact_stiffness\n");
  for (std::size_t j = 1; j < 4; ++j) vehicle.wheelsets[j].load.reset();
  EXPECT_EQ(
      messageOf(vehicle, 0.0),
      "error: <vehicle><wheelset name=\"wheelset_1\">: a Hertz contact without static load has no stiffness (so it "
      "is with 4 wheelsets of the vehicle); set gravity > 0, or give its load or contact_stiffness\n");
}

TEST(Gravity, ThatIsNegativeOrNotANumberIsTheCallersMistake) {
  EXPECT_THROW(static_cast<void>(restOf(topologyOf(paperVehicle()), -9.81)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(restOf(topologyOf(paperVehicle()), std::nan(""))), std::invalid_argument);
}

}  // namespace
}  // namespace vehicle::test
