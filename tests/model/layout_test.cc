#include "libvehicle/model/layout.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "libvehicle/model/compiled_model.h"
#include "tests/support/vehicles.h"

namespace vehicle {
namespace {

using test::contactVehicle;
using test::paperVehicle;

TEST(OutputLayout, EveryColumnIsFoundByItsKeyAndByItsName) {
  for (const Vehicle& vehicle : {paperVehicle(), contactVehicle()}) {
    const OutputLayout layout(topologyOf(vehicle));
    std::set<std::string> names;
    for (int column = 0; column < layout.size(); ++column) {
      const OutputKey& key = layout.keys()[static_cast<std::size_t>(column)];
      const std::string& name = layout.channels()[static_cast<std::size_t>(column)].name;
      EXPECT_EQ(layout.column(key), column) << name;
      EXPECT_EQ(layout.find(name), key) << name;
      EXPECT_TRUE(names.insert(name).second) << name;
    }
  }
}

TEST(OutputLayout, HasNoColumnForWhatAPartDoesNot) {
  const Topology topology = topologyOf(paperVehicle());
  const OutputLayout layout(topology);
  EXPECT_EQ(layout.column(PartKind::kBody, 1, Quantity::kPitch), -1);  // a bogie bounces alone
  EXPECT_EQ(layout.column(PartKind::kWheelset, 0, Quantity::kZ), -1);  // it follows the rail
  EXPECT_EQ(layout.column(PartKind::kSuspension, 0, Quantity::kLoad), -1);
  EXPECT_FALSE(layout.find("front_bogie.pitch"));
  EXPECT_FALSE(layout.find("carbody"));
}

TEST(OutputLayout, ARateLeadsBackToWhatItChanges) {
  const OutputLayout layout(topologyOf(paperVehicle()));
  const auto levelOf = [&](const char* name) -> std::string {
    const int level = layout.levelOf(layout.column(*layout.find(name)));
    return level < 0 ? "" : layout.channels()[static_cast<std::size_t>(level)].name;
  };
  EXPECT_EQ(levelOf("carbody.az"), "carbody.vz");
  EXPECT_EQ(levelOf("carbody.vz"), "carbody.z");
  EXPECT_EQ(levelOf("carbody.pitch_acc"), "carbody.pitch_rate");
  EXPECT_EQ(levelOf("carbody.z"), "");
  EXPECT_EQ(levelOf("wheelset_1.load"), "");
}

TEST(CompiledModel, StatesAreColumnsRatesBehindCoordinates) {
  const CompiledModel model = compile(contactVehicle(), 9.81);
  ASSERT_EQ(static_cast<int>(model.state_keys.size()), model.states.size());
  for (int q = 0; q < model.states.coordinates; ++q) {
    const int level = model.outputs.column(model.state_keys[static_cast<std::size_t>(q)]);
    const int rate = model.outputs.column(model.state_keys[static_cast<std::size_t>(model.states.rate(q))]);
    EXPECT_EQ(model.outputs.levelOf(rate), level);
    EXPECT_EQ(model.state_channels[static_cast<std::size_t>(q)],
              model.outputs.channels()[static_cast<std::size_t>(level)]);
  }
}

TEST(CompiledModel, RefusesWhatCheckRefusesAndAWeightThatNothingCarries) {
  Vehicle wrong = paperVehicle();
  wrong.bodies[0].mass = -1.0;
  EXPECT_THROW(static_cast<void>(compile(wrong, 9.81)), InvalidInput);
  Vehicle loose = paperVehicle();
  for (Element& each : loose.elements) each.stiffness_z = 0.0;
  EXPECT_THROW(static_cast<void>(compile(loose, 9.81)), InvalidInput);
  EXPECT_THROW(static_cast<void>(compile(paperVehicle(), -9.81)), std::invalid_argument);
}

}  // namespace
}  // namespace vehicle
