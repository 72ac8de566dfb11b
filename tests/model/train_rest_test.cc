#include <string>

#include <gtest/gtest.h>

#include "libvehicle/model/rest.h"
#include "tests/support/tolerance.h"
#include "tests/support/trains.h"

namespace vehicle {
namespace {

// A coupling carries nothing at rest: each vehicle stands as it stands alone. Places up to 110 m from the origin cost
// its arms 1e-14 m of 9 m, and its loads as much of theirs.
TEST(RestOfATrain, IsThatOfItsVehiclesEachAlone) {
  for (const Vehicle& vehicle : {test::bogiePitchHeightsVehicle(), test::contactVehicle(), test::hertzVehicle()}) {
    const Topology own = topologyOf(vehicle);
    const Rest alone = restOf(own, 9.81);
    const Topology topology = topologyOf(assembled(test::equalTrain(vehicle, 5, 26.0)));
    const Rest rest = restOf(topology, 9.81);
    ASSERT_EQ(rest.coordinates.size(), 5 * alone.coordinates.size());
    for (std::size_t unit = 0; unit < 5; ++unit) {
      for (std::size_t b = 0; b < own.bodies.size(); ++b) {
        const TopologyBody& body = topology.bodies[unit * own.bodies.size() + b];
        const double expected = alone.coordinates[static_cast<std::size_t>(own.bodies[b].z_index)];
        EXPECT_WITHIN(rest.coordinates[static_cast<std::size_t>(body.z_index)], expected, 1e-13);
        EXPECT_WITHIN(rest.pitch_stiffness[unit * own.bodies.size() + b], alone.pitch_stiffness[b],
                      1e-13 * std::abs(alone.pitch_stiffness[b]));
      }
      for (std::size_t j = 0; j < own.wheelsets.size(); ++j) {
        EXPECT_WITHIN(rest.wheel_load[4 * unit + j], alone.wheel_load[j], 1e-13 * alone.wheel_load[j]);
        EXPECT_WITHIN(rest.contact_stiffness[4 * unit + j], alone.contact_stiffness[j],
                      1e-13 * alone.contact_stiffness[j]);
      }
      for (std::size_t s = 0; s < own.suspensions.size(); ++s) {
        EXPECT_WITHIN(rest.suspension_load[unit * own.suspensions.size() + s], alone.suspension_load[s],
                      1e-13 * alone.suspension_load[s]);
      }
    }
    for (std::size_t s = 5 * own.suspensions.size(); s < topology.suspensions.size(); ++s) {
      EXPECT_EQ(rest.suspension_load[s], 0.0);
    }
  }
}

// All vehicles that cannot stand are told, not the first alone.
TEST(RestOfATrain, TellsEveryVehicleThatItsSpringsDoNotCarry) {
  Vehicle train = assembled(test::equalTrain(test::paperVehicle(), 3, 16.0));
  for (const char* unit : {"coach_1", "coach_3"}) {
    for (Element& each : train.elements) {
      if (each.name == std::string(unit) + ".secondary") each.stiffness_z = 0.0;
    }
    for (Suspension& each : train.suspensions) {
      if (each.name.starts_with(unit) && each.element.ends_with("secondary")) each.preload = 1e3;
    }
  }
  // Each carbody still hangs on springs as far as the check of names can see: through its neighbour.
  try {
    (void)restOf(topologyOf(train), 9.81);
    FAIL() << "accepted";
  } catch (const InvalidInput& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("coach_1.carbody"), std::string::npos) << text;
    EXPECT_NE(text.find("coach_3.carbody"), std::string::npos) << text;
    EXPECT_EQ(text.find("coach_2"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace vehicle
