#include <functional>
#include <memory>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "libvehicle/model/layout.h"
#include "libvehicle/model/topology.h"
#include "tests/support/vehicles.h"

// Which parts of a vehicle with mistakes can still be judged.
namespace vehicle {
namespace {

/// The paper's vehicle with a line for each part, as a file has them.
Vehicle numbered() {
  Vehicle made = test::paperVehicle();
  int line = 1;
  const auto place = [&](Origin& origin) { origin = {{"v.xml", ++line}}; };
  for (Element& each : made.elements) place(each.origin);
  for (Body& each : made.bodies) place(each.origin);
  for (Wheelset& each : made.wheelsets) place(each.origin);
  for (Suspension& each : made.suspensions) place(each.origin);
  return made;
}

/// Marks an attribute as one that the reader could not understand.
void makeUnknown(Origin& origin, const std::string& attribute) {
  PartText text;
  text.attributes = {{attribute, attribute, "?", origin.line, true, false}};
  text.whole = false;
  origin.text = std::make_shared<const PartText>(text);
}

std::set<std::string> movingAfter(const std::function<void(Vehicle&)>& change) {
  Vehicle made = numbered();
  change(made);
  std::set<std::string> moving;
  for (const TopologyBody& each : soundTopologyOf(made).bodies) {
    if (each.z_index >= 0) moving.insert(each.name);
  }
  return moving;
}

const std::set<std::string> kAll = {"carbody", "front_bogie", "rear_bogie"};
const std::set<std::string> kNone = {};

TEST(SoundTopology, OfARightVehicleIsItsTopology) {
  const Vehicle made = numbered();
  const Topology whole = topologyOf(made);
  const Topology sound = soundTopologyOf(made);
  EXPECT_EQ(sound.coordinates, whole.coordinates);
  EXPECT_EQ(sound.suspensions.size(), whole.suspensions.size());
  EXPECT_EQ(resultChannels(sound), resultChannels(whole));
}

TEST(SoundTopology, WhatSpringsTieToAWrongPartStandsStill) {
  EXPECT_EQ(movingAfter([](Vehicle&) {}), kAll);
  EXPECT_EQ(movingAfter([](Vehicle& made) { made.bodies[1].mass = -1.0; }), kNone);
  EXPECT_EQ(movingAfter([](Vehicle& made) { makeUnknown(made.elements[0].origin, "stiffness_z"); }), kNone);
  EXPECT_EQ(movingAfter([](Vehicle& made) { made.suspensions[2].upper = "front_bogi"; }), kNone);
}

// A given preload is the same whatever stands at its other end.
TEST(SoundTopology, GivenPreloadsKeepMistakesApart) {
  const auto cutFront = [](Vehicle& made) {
    for (const char* name : {"secondary_front", "primary_1", "primary_2"}) {
      test::named(made.suspensions, name).preload = 1e5;
    }
  };
  const std::set<std::string> front = {"front_bogie"};
  EXPECT_EQ(movingAfter([&](Vehicle& made) {
              cutFront(made);
              test::named(made.bodies, "rear_bogie").mass = -1.0;
            }),
            front);
  EXPECT_EQ(movingAfter([&](Vehicle& made) {
              cutFront(made);
              test::named(made.wheelsets, "wheelset_1").name = "wheelset_2";
              test::named(made.suspensions, "primary_1").lower = "wheelset_2";
            }),
            kAll);
  // A given load does not ask for the stiffness either.
  EXPECT_EQ(movingAfter([&](Vehicle& made) {
              cutFront(made);
              makeUnknown(made.elements[0].origin, "stiffness_z");
            }),
            front);
  // Loads do not depend on inertias.
  EXPECT_EQ(movingAfter([&](Vehicle& made) { makeUnknown(made.bodies[0].origin, "pitch_inertia"); }), kAll);
  // A spring without a body may be any body's; front_bogie is carried by preloads alone.
  EXPECT_EQ(movingAfter([&](Vehicle& made) {
              cutFront(made);
              test::named(made.suspensions, "primary_3").upper = "nowhere";
            }),
            front);
}

TEST(SoundTopology, OfAVehicleWithoutLinesHoldsNothingMoving) {
  Vehicle made = test::paperVehicle();
  made.bodies[1].mass = -1.0;
  EXPECT_EQ(soundTopologyOf(made).coordinates, 0);
}

}  // namespace
}  // namespace vehicle
