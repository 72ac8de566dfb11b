#include "libvehicle/definition/train.h"

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/model/layout.h"
#include "libvehicle/model/topology.h"
#include "tests/support/tolerance.h"
#include "tests/support/trains.h"

namespace vehicle {
namespace {

using test::named;

Origin line(int number) {
  Origin origin;
  origin.file = "train.xml";
  origin.line = number;
  return origin;
}

// The lopsided vehicle ahead of two of the paper's, as a file would give it.
Train rightTrain() {
  Train made;
  made.name = "express";
  made.origin = line(1);
  made.vehicles = {test::unitsOf(test::asymmetricVehicle(), "power", 1, 20.0),
                   test::unitsOf(test::paperVehicle(), "", 2, 16.0, 7.5)};
  made.vehicles[0].origin = line(2);
  made.vehicles[1].origin = line(3);
  made.couplings = {test::coupling(50e3, 20e3, 7.0)};
  made.couplings[0].origin = line(4);
  return made;
}

std::string problemsAfter(const std::function<void(Train&)>& change) {
  Train made = rightTrain();
  change(made);
  return check(made).text();
}

TEST(CheckTrain, WhatIsInOrderPasses) {
  EXPECT_EQ(check(rightTrain()).text(), "");
  EXPECT_EQ(check(test::mixedTrain()).text(), "");
  EXPECT_EQ(check(test::equalTrain(test::contactVehicle(), 4, 26.0)).text(), "");
  EXPECT_EQ(problemsAfter([](Train& made) { made.couplings.clear(); }), "");
  EXPECT_EQ(problemsAfter([](Train& made) { made.vehicles.resize(1); }), "");
}

TEST(CheckTrain, HasANameAndVehicles) {
  EXPECT_EQ(problemsAfter([](Train& made) { made.name = "the train"; }),
            "train.xml:1: error: <train>: name=\"the train\"; a name is made of the letters a-z and A-Z, digits, \"_\" "
            "and \"-\"\n");
  EXPECT_EQ(problemsAfter([](Train& made) { made.vehicles.clear(); }),
            "train.xml:1: error: <train>: has no <vehicle>; a train has at least one\n");
}

TEST(CheckTrain, ValuesAreInTheirRanges) {
  const auto says = [](const std::function<void(Train&)>& change, const std::string& text) {
    EXPECT_EQ(problemsAfter(change), "train.xml:" + text + "\n");
  };
  says([](Train& made) { made.vehicles[1].count = 0; }, "3: error: <train><vehicle>: count=\"0\"; must be >= 1");
  says([](Train& made) { made.vehicles[0].spacing = 0.0; }, "2: error: <train><vehicle>: spacing=\"0 m\"; must be > 0");
  says([](Train& made) { made.vehicles[1].end_x = -7.5; }, "3: error: <train><vehicle>: end_x=\"-7.5 m\"; must be > 0");
  says([](Train& made) { made.vehicles[0].name = "a.b"; },
       "2: error: <train><vehicle>: name=\"a.b\"; a name is made of the letters a-z and A-Z, digits, \"_\" and \"-\"");
  says([](Train& made) { made.couplings[0].stiffness_z = -50e3; },
       "4: error: <train><coupling>: stiffness_z=\"-50 kN/m\"; must be >= 0");
  says([](Train& made) { made.couplings[0].damping_z = -20e3; },
       "4: error: <train><coupling>: damping_z=\"-20 kN*s/m\"; must be >= 0");
  says([](Train& made) { made.couplings[0].end_x = 0.0; }, "4: error: <train><coupling>: end_x=\"0 m\"; must be > 0");
  says([](Train& made) { made.vehicles[1].count = 20000; },
       "1: error: <train>: has 20001 vehicles; must be at most 10000");
}

TEST(CheckTrain, ThereAreAsManyCouplingsAsGapsOrOneForAll) {
  EXPECT_EQ(problemsAfter([](Train& made) { made.couplings.assign(2, made.couplings[0]); }), "");
  EXPECT_EQ(problemsAfter([](Train& made) { made.couplings.assign(3, made.couplings[0]); }),
            "train.xml:1: error: <train>: has 3 couplings between 3 vehicles; give one <coupling> for all, or 2 of "
            "them from front to rear\n");
}

TEST(CheckTrain, ACouplingNeedsOneCarbodyAndItsEnds) {
  EXPECT_EQ(problemsAfter([](Train& made) {
              made.vehicles[0].vehicle.bodies.push_back(test::body("roof", 100.0, 0.0, std::nullopt, {Motion::kZ}));
              made.vehicles[0].vehicle.suspensions.push_back(
                  test::suspension("roof_spring", "secondary_soft", "roof", "front_bogie", 6.0));
            }),
            "train.xml:2: error: <train><vehicle>: \"asymmetric.xml\" has no carbody to couple: not just one of its "
            "bodies is without another above it; leave the <coupling> out, or let one body alone stand on top\n");
  EXPECT_EQ(problemsAfter([](Train& made) { made.couplings[0].end_x.reset(); }),
            "train.xml:2: error: <train><vehicle>: \"asymmetric.xml\" has no end_x, and its coupling (line 4) has "
            "none; give one of them, e.g. end_x=\"12.5 m\"\n");
}

// Half of 20 m and half of 16 m from origin to origin, the carbody's CG 2.3 m ahead of its own: 18 + 2.3 - 13.3 - 7.5.
TEST(CheckTrain, NeighboursDoNotStandIntoEachOther) {
  EXPECT_EQ(problemsAfter([](Train& made) { made.couplings[0].end_x = 13.3; }),
            "train.xml:3: error: <train><vehicle>: the ends of \"asymmetric.xml\" and \"al-oraiqat-2017.xml\" overlap "
            "by 0.5 m; take a larger spacing or a smaller end_x\n");
  EXPECT_EQ(problemsAfter([](Train& made) { made.couplings[0].end_x = 12.8; }), "");  // they touch
}

TEST(CheckTrain, HeightsAreGivenForAllVehiclesOrForNone) {
  EXPECT_EQ(problemsAfter([](Train& made) { made.vehicles[1].vehicle = test::heightsVehicle(); }),
            "train.xml:2: error: <train><vehicle>: \"asymmetric.xml\" has no heights, but \"al-oraiqat-2017.xml\" "
            "(line 3) has some; heights are given for all vehicles of a train or for none\n");
  EXPECT_EQ(problemsAfter([](Train& made) { made.couplings[0].z = 1.0; }),
            "train.xml:4: error: <train><coupling>: z=\"1 m\", but the vehicles have no heights; leave z out, or give "
            "the vehicles heights\n");
}

TEST(CheckTrain, TellsTheProblemsOfItsVehicles) {
  EXPECT_EQ(problemsAfter([](Train& made) { made.vehicles[1].vehicle.bodies[0].mass = -1.0; }),
            "error: <vehicle><body name=\"carbody\">: mass=\"-1 kg\"; must be > 0\n");
  EXPECT_EQ(problemsAfter([](Train& made) { made.vehicles[0].vehicle = assembled(test::mixedTrain()); }),
            "train.xml:2: error: <train><vehicle>: \"asymmetric.xml\" is a train itself; list its vehicles one by "
            "one\n");
}

TEST(CheckTrain, VehiclesThatHaveNotBeenReadAreJudgedByTheirOwnLine) {
  Train train = rightTrain();
  train.vehicles[0].vehicle = Vehicle();
  EXPECT_EQ(check(train).text(), "");
  try {
    (void)assembled(train);
    FAIL() << "accepted";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(),
                 "train.xml:2: error: <train><vehicle>: \"asymmetric.xml\" has not been read; read the "
                 "vehicle files before the train is assembled\n");
  }
  train.vehicles[0].file.clear();
  EXPECT_EQ(check(train).text(),
            "train.xml:2: error: <train><vehicle>: file is empty; name a file, e.g. file=\"coach.xml\"\n");
}

TEST(CarbodyOf, IsTheOneBodyThatNothingStandsOn) {
  EXPECT_EQ(carbodyOf(test::paperVehicle()), 0);
  EXPECT_EQ(carbodyOf(test::asymmetricVehicle()), 1);
  EXPECT_EQ(carbodyOf(Vehicle()), -1);
  Vehicle two = test::paperVehicle();
  two.suspensions.erase(two.suspensions.begin());
  EXPECT_EQ(carbodyOf(two), -1);
}

TEST(AssembledTrain, IsAVehicleWithoutProblems) {
  for (const Train& train :
       {rightTrain(), test::mixedTrain(), test::equalTrain(test::bogiePitchHeightsVehicle(), 5, 26.0)}) {
    const Vehicle made = assembled(train);
    EXPECT_EQ(check(made).text(), "");
    EXPECT_EQ(made.name, train.name);
    EXPECT_EQ(static_cast<long>(made.units.size()), vehiclesOf(train));
  }
}

TEST(AssembledTrain, NumbersItsVehiclesFromTheLeadingOneAndCallsTheirPartsAfterThem) {
  const Vehicle made = assembled(rightTrain());
  ASSERT_EQ(made.units.size(), 3u);
  EXPECT_EQ(made.units[0].name, "power_1");
  EXPECT_EQ(made.units[2].name, "al-oraiqat-2017_3");
  EXPECT_EQ(made.bodies[1].name, "power_1.carbody");
  EXPECT_EQ(made.bodies[3].name, "al-oraiqat-2017_2.carbody");
  EXPECT_EQ(made.elements.back().name, "coupling");
  EXPECT_EQ(made.suspensions.back().name, "coupling_2");
  const std::vector<Channel> columns = resultChannels(topologyOf(made));
  EXPECT_EQ(columns.front().name, "power_1.rear_bogie.z");
  EXPECT_EQ(columns.back().name, "al-oraiqat-2017_3.wheelset_4.load");
}

TEST(AssembledTrain, EachVehicleStandsHalfItsSpacingAndHalfThatOfTheOneAheadBehind) {
  const Train train = rightTrain();
  const Topology alone = topologyOf(test::paperVehicle());
  const Topology topology = topologyOf(assembled(train));
  // All lengths are binary fractions but 3.725 and 2.3 m: a few roundings of 50 m.
  EXPECT_WITHIN(topology.bodies[1].x, 2.3, 0.0);
  EXPECT_WITHIN(topology.bodies[3].x, -18.0, 1e-14);
  EXPECT_WITHIN(topology.bodies[6].x, -34.0, 1e-14);
  for (std::size_t j = 0; j < 4; ++j) {
    EXPECT_WITHIN(topology.wheelsets[8 + j].x, alone.wheelsets[j].x - 34.0, 1e-14);
  }
  for (std::size_t s = 0; s < 6; ++s) {
    EXPECT_WITHIN(topology.suspensions[12 + s].arm_upper, alone.suspensions[s].arm_upper, 2e-14);
  }
}

TEST(AssembledTrain, GroupsMoveWithTheirVehicle) {
  Train train = rightTrain();
  Vehicle& grouped = train.vehicles[1].vehicle;
  grouped.groups = {{"front", 3.725, {}}};
  for (Body& each : grouped.bodies) {
    if (each.name != "front_bogie") continue;
    each.group = "front";
    each.x = 0.0;
  }
  grouped.points = {{"floor", "front", "carbody", -3.0, {}}};
  const Vehicle made = assembled(train);
  EXPECT_EQ(made.groups[1].name, "al-oraiqat-2017_3.front");
  const Topology topology = topologyOf(made);
  EXPECT_WITHIN(topology.bodies[7].x, 3.725 - 34.0, 1e-14);  // rounding of 34 m
  EXPECT_EQ(topology.points[1].name, "al-oraiqat-2017_3.floor");
  EXPECT_EQ(topology.points[1].body, 6);
  EXPECT_WITHIN(topology.points[1].arm, 0.725, 1e-14);
}

TEST(AssembledTrain, CouplingsJoinTheEndsOfNeighboursAndCarryNoStaticLoad) {
  const Topology topology = topologyOf(assembled(rightTrain()));
  ASSERT_EQ(topology.suspensions.size(), 20u);
  const TopologySuspension& first = topology.suspensions[18];
  EXPECT_EQ(first.name, "coupling_1");
  EXPECT_EQ(first.upper, 1);
  EXPECT_EQ(first.lower_body, 3);
  EXPECT_WITHIN(first.arm_upper, -7.0, 1e-14);  // rounding of the places, below 50 m
  EXPECT_WITHIN(first.arm_lower, 7.5, 1e-14);
  EXPECT_EQ(first.stiffness, 50e3);
  EXPECT_EQ(first.damping, 20e3);
  EXPECT_EQ(first.preload, 0.0);
  const TopologySuspension& second = topology.suspensions[19];
  EXPECT_EQ(second.upper, 3);
  EXPECT_EQ(second.lower_body, 6);
  EXPECT_WITHIN(second.arm_upper, -7.5, 1e-14);
}

TEST(AssembledTrain, EachGapMayHaveItsOwnCoupling) {
  const Topology topology = topologyOf(assembled(test::mixedTrain()));
  EXPECT_EQ(topology.suspensions[18].stiffness, 180e3);
  EXPECT_EQ(topology.suspensions[19].stiffness, 90e3);
  EXPECT_WITHIN(topology.suspensions[18].arm_upper, -7.5, 1e-14);  // rounding of the places, below 50 m
  EXPECT_WITHIN(topology.suspensions[18].arm_lower, 7.2, 1e-14);
  EXPECT_WITHIN(topology.suspensions[19].arm_lower, 8.1, 1e-14);  // the coupling's, where the vehicle has none
}

TEST(AssembledTrain, CouplingsActAtTheirOwnHeightOrAtThatOfEachCentreOfGravity) {
  Train train = test::equalTrain(test::heightsVehicle(), 2, 16.0);
  EXPECT_EQ(topologyOf(assembled(train)).suspensions.back().height_upper, 0.0);
  train.couplings[0].z = 1.0;
  const Topology topology = topologyOf(assembled(train));
  EXPECT_EQ(topology.suspensions.back().height_upper, 1.0 - 2.1);
  EXPECT_EQ(topology.suspensions.back().height_lower, 1.0 - 2.1);
}

TEST(AssembledTrain, OfOneVehicleIsThatVehicleUnderAnotherName) {
  const Topology alone = topologyOf(test::asymmetricVehicle());
  Train train = rightTrain();
  train.vehicles.resize(1);
  const Topology topology = topologyOf(assembled(train));
  ASSERT_EQ(topology.suspensions.size(), alone.suspensions.size());
  for (std::size_t s = 0; s < alone.suspensions.size(); ++s) {
    EXPECT_EQ(topology.suspensions[s].arm_upper, alone.suspensions[s].arm_upper);
    EXPECT_EQ(topology.suspensions[s].name, "power_1." + alone.suspensions[s].name);
  }
}

// A dot separates a part from its vehicle; in a vehicle of its own it would let two parts share an address.
TEST(CheckVehicle, ADotStandsInNamesOfATrainsPartsOnly) {
  Vehicle vehicle = test::paperVehicle();
  vehicle.bodies[0].name = "coach_1.carbody";
  for (Suspension& each : vehicle.suspensions) {
    if (each.upper == "carbody") each.upper = "coach_1.carbody";
  }
  const std::string refused =
      "error: <vehicle><body name=\"coach_1.carbody\">: name=\"coach_1.carbody\"; a name is made of the letters a-z "
      "and A-Z, digits, \"_\" and \"-\"\n";
  EXPECT_EQ(check(vehicle).text(), refused);
  vehicle.units = {{"coach_2", "", 0.0, {}}};
  EXPECT_EQ(check(vehicle).text(), refused);
  vehicle.units = {{"coach_1", "", 0.0, {}}};
  EXPECT_EQ(check(vehicle).text(), "");
}

}  // namespace
}  // namespace vehicle
