#include "libvehicle/model/topology.h"
#include "libvehicle/model/compiled_model.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle {
namespace {

using test::named;

std::vector<std::string> namesOf(const std::vector<Channel>& channels) {
  std::vector<std::string> names;
  for (const Channel& each : channels) names.push_back(each.name);
  return names;
}

TEST(TopologyOf, CoordinatesFollowTheFileBodiesFirst) {
  const Topology paper = topologyOf(test::paperVehicle());
  EXPECT_EQ(paper.coordinates, 4);
  EXPECT_EQ(paper.bodies[0].z_index, 0);
  EXPECT_EQ(paper.bodies[0].pitch_index, 1);
  EXPECT_EQ(paper.bodies[1].z_index, 2);
  EXPECT_EQ(paper.bodies[1].pitch_index, -1);
  EXPECT_EQ(paper.bodies[2].z_index, 3);
  for (const TopologyWheelset& each : paper.wheelsets) EXPECT_EQ(each.z_index, -1);
  EXPECT_FALSE(paper.has_heights);

  EXPECT_EQ(namesOf(stateChannels(topologyOf(test::asymmetricVehicle()))),
            (std::vector<std::string>{"rear_bogie.z", "carbody.z", "carbody.pitch", "front_bogie.z", "rear_bogie.vz",
                                      "carbody.vz", "carbody.pitch_rate", "front_bogie.vz"}));
}

TEST(TopologyOf, WheelsetsWithMassOnContactHaveTheLastCoordinates) {
  for (const Vehicle& vehicle : {test::contactVehicle(), test::hertzVehicle()}) {
    const Topology topology = topologyOf(vehicle);
    EXPECT_EQ(topology.coordinates, 10);
    for (int j = 0; j < 4; ++j) EXPECT_EQ(topology.wheelsets[static_cast<std::size_t>(j)].z_index, 6 + j);
  }
  EXPECT_EQ(topologyOf(test::bogiePitchVehicle()).coordinates, 6);
  EXPECT_EQ(topologyOf(test::bogiePitchVehicle()).wheelsets[0].mass, 1813.0);
  const Topology contact = topologyOf(test::contactVehicle());
  EXPECT_EQ(contact.wheelsets[3].contact_stiffness, 2.4e9);
  EXPECT_EQ(contact.wheelsets[3].contact_damping, 20e3);
  EXPECT_EQ(topologyOf(test::hertzVehicle()).wheelsets[3].hertz_constant, 200e9);
}

TEST(TopologyOf, ArmsCountFromTheCentreOfGravityOfEachBody) {
  const Topology topology = topologyOf(test::asymmetricBogiePitchVehicle());
  const TopologySuspension& rear = topology.suspensions[1];
  EXPECT_EQ(rear.name, "secondary_rear");
  EXPECT_EQ(topology.bodies[static_cast<std::size_t>(rear.upper)].name, "carbody");
  EXPECT_EQ(topology.bodies[static_cast<std::size_t>(rear.lower_body)].name, "rear_bogie");
  EXPECT_EQ(rear.lower_wheelset, -1);
  EXPECT_EQ(rear.arm_upper, -2.65 - 2.3);
  EXPECT_EQ(rear.arm_lower, -2.65 - -2.5);
  const TopologySuspension& primary = topology.suspensions[0];
  EXPECT_EQ(primary.lower_body, -1);
  EXPECT_EQ(topology.wheelsets[static_cast<std::size_t>(primary.lower_wheelset)].name, "wheelset_4");
  EXPECT_EQ(primary.arm_upper, -3.6 - -2.5);
  EXPECT_EQ(primary.arm_lower, 0.0);
  EXPECT_EQ(primary.stiffness, 3.9e6);
  EXPECT_EQ(primary.damping, 12e3);
}

TEST(TopologyOf, SidesAreSummed) {
  Vehicle vehicle = test::paperVehicle();
  Suspension& secondary = named(vehicle.suspensions, "secondary_front");
  secondary.sides = 2;
  secondary.y = 1.0;
  secondary.preload = 250e3;
  const Topology topology = topologyOf(vehicle);
  EXPECT_EQ(topology.suspensions[0].stiffness, 2.0 * 2660e3);
  EXPECT_EQ(topology.suspensions[0].damping, 2.0 * 100e3);
  EXPECT_EQ(topology.suspensions[0].preload, 250e3);
  EXPECT_EQ(topology.suspensions[1].stiffness, 2660e3);
  EXPECT_EQ(topology.suspensions[1].preload, std::nullopt);
}

TEST(TopologyOf, GroupsAreDissolvedAndMoveAsOne) {
  Vehicle grouped = test::paperVehicle();
  Group front;
  front.name = "front";
  front.x = 3.725;
  grouped.groups = {front};
  const auto join = [&](auto& part, double x) {
    part.group = "front";
    part.x = x;
  };
  join(named(grouped.bodies, "front_bogie"), 0.0);
  join(named(grouped.wheelsets, "wheelset_1"), 1.5);
  join(named(grouped.wheelsets, "wheelset_2"), -1.5);
  join(named(grouped.suspensions, "primary_1"), 1.5);
  join(named(grouped.suspensions, "primary_2"), -1.5);
  join(named(grouped.suspensions, "secondary_front"), 0.0);
  Point floor;
  floor.name = "floor";
  floor.body = "carbody";
  grouped.points = {floor};
  join(grouped.points[0], 0.0);

  for (const double x : {3.725, 4.0}) {
    grouped.groups[0].x = x;
    const Topology topology = topologyOf(grouped);
    EXPECT_EQ(topology.bodies[1].x, x);
    EXPECT_EQ(topology.wheelsets[0].x, x + 1.5);
    EXPECT_EQ(topology.wheelsets[1].x, x - 1.5);
    EXPECT_EQ(topology.wheelsets[2].x, -2.225);
    EXPECT_EQ(topology.suspensions[0].arm_upper, x);
    EXPECT_EQ(topology.suspensions[0].arm_lower, 0.0);
    // 4 + 1.5 and 3.725 + 1.5 and their difference are exact in binary or off by one last bit of 5.
    EXPECT_WITHIN(topology.suspensions[2].arm_upper, 1.5, 1e-15);
    EXPECT_EQ(topology.points[0].arm, x);
    EXPECT_EQ(topology.points[0].body, 0);
  }
}

TEST(TopologyOf, HeightsCountFromTheCentreOfGravityOfEachBody) {
  const Topology topology = topologyOf(test::bogiePitchHeightsVehicle(0.5));
  EXPECT_TRUE(topology.has_heights);
  EXPECT_EQ(topology.bodies[0].z, 2.1);
  EXPECT_EQ(topology.wheelsets[0].z, 0.46);
  // Heights of 0.45..2.1 m are subtracted: a last bit of 2 m.
  for (const TopologySuspension& each : topology.suspensions) {
    EXPECT_WITHIN(each.height_upper, -0.5, 5e-16);
    EXPECT_WITHIN(each.height_lower, each.lower_body >= 0 ? -0.5 : 0.0, 5e-16);
  }
  Vehicle noAxleHeights = test::heightsVehicle();
  for (Wheelset& each : noAxleHeights.wheelsets) each.z.reset();
  EXPECT_TRUE(topologyOf(noAxleHeights).has_heights);
  EXPECT_EQ(topologyOf(noAxleHeights).suspensions[2].height_lower, 0.0);
}

TEST(TopologyOf, ABodyWithoutPlanarMotionHasNoCoordinate) {
  Vehicle vehicle = test::paperVehicle();
  named(vehicle.bodies, "rear_bogie").motion = {Motion::kX, Motion::kYaw};
  const Topology topology = topologyOf(vehicle);
  EXPECT_EQ(topology.coordinates, 3);
  EXPECT_EQ(topology.bodies[2].z_index, -1);
  EXPECT_EQ(topology.bodies[2].pitch_index, -1);
}

TEST(Compile, RefusesAVehicleThatContradictsItself) {
  Vehicle vehicle = test::paperVehicle();
  vehicle.bodies[0].mass = -1.0;
  vehicle.suspensions[2].lower = "wheelset_9";
  try {
    (void)compile(vehicle, 9.81);
    FAIL() << "compile() gave a model";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.problems().text(), check(vehicle).text());
    EXPECT_EQ(error.problems().size(), 2u);
  }
}

TEST(StateChannels, ArePositionsThenVelocitiesWithUnits) {
  EXPECT_EQ(stateChannels(topologyOf(test::paperVehicle())), (std::vector<Channel>{{"carbody.z", "m"},
                                                                                   {"carbody.pitch", "rad"},
                                                                                   {"front_bogie.z", "m"},
                                                                                   {"rear_bogie.z", "m"},
                                                                                   {"carbody.vz", "m/s"},
                                                                                   {"carbody.pitch_rate", "rad/s"},
                                                                                   {"front_bogie.vz", "m/s"},
                                                                                   {"rear_bogie.vz", "m/s"}}));
  const std::vector<Channel> contact = stateChannels(topologyOf(test::contactVehicle()));
  ASSERT_EQ(contact.size(), 20u);
  EXPECT_EQ(contact[9], (Channel{"wheelset_4.z", "m"}));
  EXPECT_EQ(contact[19], (Channel{"wheelset_4.vz", "m/s"}));
}

TEST(ResultChannels, AreBodiesSuspensionsWheelsetsPointsInTheOrderOfTheFile) {
  Vehicle vehicle = test::paperVehicle();
  Point floor;
  floor.name = "floor_mid";
  floor.body = "carbody";
  vehicle.points = {floor};
  const std::vector<Channel> channels = resultChannels(topologyOf(vehicle));
  EXPECT_EQ(namesOf(channels), (std::vector<std::string>{"carbody.z",
                                                         "carbody.pitch",
                                                         "carbody.vz",
                                                         "carbody.pitch_rate",
                                                         "carbody.az",
                                                         "carbody.pitch_acc",
                                                         "front_bogie.z",
                                                         "front_bogie.vz",
                                                         "front_bogie.az",
                                                         "rear_bogie.z",
                                                         "rear_bogie.vz",
                                                         "rear_bogie.az",
                                                         "secondary_front.deflection",
                                                         "secondary_front.force",
                                                         "secondary_rear.deflection",
                                                         "secondary_rear.force",
                                                         "primary_1.deflection",
                                                         "primary_1.force",
                                                         "primary_2.deflection",
                                                         "primary_2.force",
                                                         "primary_3.deflection",
                                                         "primary_3.force",
                                                         "primary_4.deflection",
                                                         "primary_4.force",
                                                         "wheelset_1.rail_z",
                                                         "wheelset_1.load",
                                                         "wheelset_2.rail_z",
                                                         "wheelset_2.load",
                                                         "wheelset_3.rail_z",
                                                         "wheelset_3.load",
                                                         "wheelset_4.rail_z",
                                                         "wheelset_4.load",
                                                         "floor_mid.z",
                                                         "floor_mid.vz",
                                                         "floor_mid.az"}));
  const std::vector<std::string> units = {"m", "rad", "m/s", "rad/s", "m/s^2", "rad/s^2"};
  for (std::size_t i = 0; i < units.size(); ++i) EXPECT_EQ(channels[i].unit, units[i]);
  EXPECT_EQ(channels[12].unit, "m");
  EXPECT_EQ(channels[13].unit, "N");
  EXPECT_EQ(channels[24].unit, "m");
  EXPECT_EQ(channels[25].unit, "N");
}

TEST(ResultChannels, AWheelsetWithItsOwnMotionHasItBetweenRailAndLoad) {
  const std::vector<std::string> names = namesOf(resultChannels(topologyOf(test::contactVehicle())));
  const std::vector<std::string> tail(names.end() - 5, names.end());
  EXPECT_EQ(tail, (std::vector<std::string>{"wheelset_4.rail_z", "wheelset_4.z", "wheelset_4.vz", "wheelset_4.az",
                                            "wheelset_4.load"}));
}

}  // namespace
}  // namespace vehicle
