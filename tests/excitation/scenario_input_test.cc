#include "libvehicle/excitation/excitation.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/diagnostics/problem.h"
#include "tests/excitation/topologies.h"
#include "tests/support/tolerance.h"
#include "tests/support/tracks.h"

// Speed, distance, rigs, and what is refused.
namespace vehicle {
namespace {

using test::dip;
using test::paperTopology;
using test::ramp;
using test::scenarioOf;

std::string refusalOf(const Scenario& scenario, double speed = 20.0) {
  try {
    (void)inputOf(scenario, paperTopology(), speed);
  } catch (const InvalidInput& error) {
    return error.problems()[0].text();
  }
  return "accepted";
}

TEST(Excitation, DistanceLastsAsTheChosenSpeedSays) {
  Scenario scenario = test::paperScenario(History::kOnset);
  scenario.run.duration.reset();
  scenario.run.distance = 200.0;
  EXPECT_EQ(inputOf(scenario, paperTopology(), 20.0).end(), 10.0);
  EXPECT_EQ(inputOf(scenario, paperTopology(), 40.0).end(), 5.0);
  EXPECT_DOUBLE_EQ(breakpointsOf(inputOf(scenario, paperTopology(), 40.0)).back(), 10.45 / 40.0);
}

TEST(Excitation, RigDrivesTheWheelsetsItNames) {
  Scenario scenario = test::paperScenario(History::kOnset);
  scenario.track.reset();
  scenario.rig.emplace();
  RigInput first;
  first.wheelset = "wheelset_3";
  first.sines.resize(2);
  first.sines[0].amplitude = 6.2e-3;
  first.sines[0].angular_frequency = 5.03;
  first.sines[0].phase = 0.3;
  first.sines[1].amplitude = 1e-3;
  first.sines[1].angular_frequency = 9.0;
  RigInput second;
  second.wheelset = "wheelset_1";
  second.sines = {first.sines[0]};
  second.sines[0].phase = -2.0;
  scenario.rig->inputs = {first, second};
  const Input input = inputOf(scenario, paperTopology(), 0.0);  // a rig has no need of a speed
  EXPECT_EQ(input.segments(), 1);
  EXPECT_EQ(input.segment(0).angular_frequency.size(), 2u);
  std::vector<double> u(8);
  for (const double t : {0.0, 0.7, 9.9}) {
    input.evaluate(0, t, u);
    const double wide = 6.2e-3;
    EXPECT_WITHIN(u[0], wide * std::sin(5.03 * t - 2.0), 1e-16);  // rounding of phases up to 90 rad
    EXPECT_EQ(u[1], 0.0);
    EXPECT_WITHIN(u[2], wide * std::sin(5.03 * t + 0.3) + 1e-3 * std::sin(9.0 * t), 1e-16);
    EXPECT_WITHIN(u[6], wide * 5.03 * std::cos(5.03 * t + 0.3) + 9e-3 * std::cos(9.0 * t), 1e-15);
    EXPECT_EQ(u[3], 0.0);
  }
  scenario.rig->inputs[0].wheelset = "wheelset_5";
  EXPECT_EQ(refusalOf(scenario, 0.0),
            "error: <scenario><rig><input>: wheelset=\"wheelset_5\" names no wheelset of the vehicle; "
            "did you mean \"wheelset_1\"?");
}

TEST(Excitation, RigMayGiveItsFrequencyInHertz) {
  Scenario scenario = test::paperScenario(History::kOnset);
  scenario.track.reset();
  scenario.rig = Rig{{RigInput{"wheelset_2", {{"", 6e-3, {}, 0.8, 0.3, {}}}, {}}}, {}};
  const Input input = inputOf(scenario, paperTopology(), 0.0);
  std::vector<double> u(8);
  input.evaluate(0, 3.1, u);
  EXPECT_WITHIN(u[1], 6e-3 * std::sin(2.0 * std::numbers::pi * 0.8 * 3.1 + 0.3), 1e-16);  // rounding of a phase of 16 rad
}

TEST(Excitation, OnsetWhoseHeightJumpsIsRefusedAndTheFadeInNamed) {
  Scenario scenario = test::paperScenario(History::kOnset);
  scenario.track->origin.file = "phase.xml";
  scenario.track->origin.line = 4;
  scenario.track->harmonics[0].phase = std::numbers::pi / 6;
  EXPECT_EQ(refusalOf(scenario),
            "phase.xml:4: error: <scenario><track>: the height jumps by 0.0025 m where history=\"onset\" begins "
            "(s = 0); must begin at 0; give fade_in=\"50 m\", or take history=\"extended\"");
  scenario.track->fade_in = 50.0;
  EXPECT_EQ(refusalOf(scenario), "accepted");
  scenario.track->fade_in.reset();
  scenario.track->history = History::kExtended;
  EXPECT_EQ(refusalOf(scenario), "accepted");
  scenario.track->history = History::kOnset;
  scenario.track->harmonics[0].phase = std::numbers::pi;  // sin(pi) = 1e-16 in doubles: no jump
  EXPECT_EQ(refusalOf(scenario), "accepted");
}

TEST(Excitation, OnsetCutsFeaturesBehindItAndRefusesTheJumpThatMakes) {
  Track track;
  track.dips = {dip(DipShape::kHalfSine, 10e-3, 2.0, -5.0)};
  EXPECT_EQ(refusalOf(scenarioOf(track, 5.0)), "accepted");
  EXPECT_TRUE(breakpointsOf(inputOf(scenarioOf(track, 5.0), paperTopology(), 20.0)).empty());
  track.ramps = {ramp(4e-3, 2.0, -5.0)};
  EXPECT_EQ(refusalOf(scenarioOf(track, 5.0)),
            "error: <scenario><track>: the height jumps by 0.004 m where history=\"onset\" begins (s = 0); must begin "
            "at 0; let dips, bumps and ramps start at 0 or beyond, or take history=\"extended\"");
}

TEST(Excitation, FeatureThatIsPassedInNoTimeIsRefused) {
  Track track;
  track.ramps = {ramp(4e-3, 1e-10, 5.0)};
  EXPECT_EQ(refusalOf(scenarioOf(track, 5.0)),
            "error: <scenario><track><ramp>: length=\"1e-10 m\" is passed in no time; must be > 1e-09 m at 20 m/s; "
            "make it longer, or take a shorter output_step");
  track.ramps.clear();
  track.dips = {dip(DipShape::kHalfSine, 4e-3, 1e-10, 5.0)};
  EXPECT_NE(refusalOf(scenarioOf(track, 5.0)), "accepted");
  track.dips.clear();
  track.fade_in = 1e-10;
  EXPECT_NE(refusalOf(scenarioOf(track, 5.0)), "accepted");
}

TEST(Excitation, RunsWithoutLengthOrSpeedAreRefused) {
  Scenario scenario = test::paperScenario(History::kOnset);
  for (const double speed : {0.0, -20.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((void)inputOf(scenario, paperTopology(), speed), std::invalid_argument);
  }
  scenario.run.duration = 4e-3;
  EXPECT_EQ(refusalOf(scenario),
            "error: <scenario><run>: lasts 4 ms with output_step=\"5 ms\"; must last at least one output step; "
            "run longer, or take a shorter output_step");
  scenario.run.duration.reset();
  EXPECT_EQ(refusalOf(scenario), "error: <scenario><run>: has no duration and no distance; give one of them");
  scenario.track.reset();
  EXPECT_EQ(refusalOf(scenario), "error: <scenario>: has no or two of <track> and <rig>; give one of them");
}

}  // namespace
}  // namespace vehicle
