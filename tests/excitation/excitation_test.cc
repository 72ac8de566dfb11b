#include "libvehicle/excitation/excitation.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/system/schedule.h"
#include "libvehicle/track/rail_profile.h"
#include "tests/excitation/topologies.h"
#include "tests/support/source_tree.h"
#include "tests/support/tolerance.h"
#include "tests/support/tracks.h"

namespace vehicle {
namespace {

using test::anyTrack;
using test::dip;
using test::paperTopology;
using test::ramp;
using test::scenarioOf;

double lagOf(const Topology& topology, std::size_t wheel) {
  double lead = topology.wheelsets[0].x;
  for (const TopologyWheelset& each : topology.wheelsets) lead = std::max(lead, each.x);
  return lead - topology.wheelsets[wheel].x;
}

// ---- the paper's rail

void expectPaperRail(History history, const std::string& name) {
  const Input input = inputOf(test::paperScenario(history), paperTopology(), 20.0);
  const Schedule schedule(input, 5e-3);
  ASSERT_EQ(schedule.samples(), 2001);
  std::vector<int> segment_at(2001, schedule.intervals().front().segment);
  for (const Interval each : schedule.intervals()) {
    if (each.sample >= 0) segment_at[static_cast<std::size_t>(each.sample)] = each.next;
  }
  std::ifstream file(test::sourcePath("tests/excitation/data/") + name);
  std::string line;
  std::getline(file, line);
  std::getline(file, line);
  std::vector<double> u(8);
  int rows = 0;
  for (; std::getline(file, line); ++rows) {
    std::stringstream cells(line);
    std::string cell;
    std::getline(cells, cell, ',');
    const int sample = std::stoi(cell);
    input.evaluate(segment_at[static_cast<std::size_t>(sample)], schedule.time(sample), u);
    for (std::size_t j = 0; j < 4; ++j) {
      std::getline(cells, cell, ',');
      // Rounding of phases up to 150 rad: 150 x 1e-16 x 5 mm = 1e-16 m.
      EXPECT_WITHIN(u[j], std::stod(cell), 3e-16) << "sample " << sample << ", wheel " << j + 1;
    }
  }
  EXPECT_EQ(rows, 591);
}

TEST(Excitation, OnsetOfThePapersRailAgreesWithItsClosedFormInFortyDigits) {
  expectPaperRail(History::kOnset, "paper_rail_onset.csv");
}

TEST(Excitation, ExtendedHistoryOfThePapersRailAgreesWithItsClosedFormInFortyDigits) {
  expectPaperRail(History::kExtended, "paper_rail_extended.csv");
}

TEST(Excitation, BreakpointsOfThePapersOnsetAreTheArrivalsOfItsWheels) {
  const Input input = inputOf(test::paperScenario(History::kOnset), paperTopology(), 20.0);
  const std::vector<double> breakpoints = breakpointsOf(input);
  ASSERT_EQ(breakpoints.size(), 3u);     // the first wheel starts on s = 0
  EXPECT_EQ(breakpoints[0], 30 * 5e-3);  // not (5.225 - 2.225) / 20 = 0.14999999999999997
  EXPECT_DOUBLE_EQ(breakpoints[1], 0.3725);
  EXPECT_DOUBLE_EQ(breakpoints[2], 0.5225);
  EXPECT_EQ(input.segment(3).angular_frequency.size(), 2u);
  EXPECT_TRUE(breakpointsOf(inputOf(test::paperScenario(History::kExtended), paperTopology(), 20.0)).empty());
}

// ---- against the direct formula over distance

// Heights and rates at random instants of every segment, and the limits at its ends, against railHeight and railSlope.
void expectTrack(const Track& track, const Topology& topology, double speed, double duration) {
  const Input input = inputOf(scenarioOf(track, duration), topology, speed);
  const std::size_t w = topology.wheelsets.size();
  ASSERT_EQ(input.channels(), static_cast<int>(w));
  EXPECT_EQ(input.begin(), 0.0);
  EXPECT_DOUBLE_EQ(input.end(), duration);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0.001, 0.999);
  std::vector<double> u(2 * w);
  for (int i = 0; i < input.segments(); ++i) {
    const double begin = input.segment(i).begin;
    const double length = input.segment(i).end - begin;
    for (int n = 0; n < 60; ++n) {
      // Two of sixty at the ends: the formula of the segment, the direct one a nanometre inside it.
      const double at = n == 0 ? 0.0 : n == 1 ? 1.0 : share(random);
      const double t = n == 1 ? input.segment(i).end : begin + at * length;
      const double inside = n == 0 ? 1e-9 : n == 1 ? -1e-9 : 0.0;
      input.evaluate(i, t, u);
      for (std::size_t j = 0; j < w; ++j) {
        const double s = speed * t - lagOf(topology, j) + inside;
        // Heights of 40 mm in all, s known to 1e-14 m of 100 m at slopes up to 0.1: 3e-15 m. A nanometre to the side
        // moves heights by 1e-10 and slopes (curvature up to 0.5 /m in all) by 1e-9.
        EXPECT_WITHIN(u[j], railHeight(track, s), inside == 0.0 ? 5e-15 : 4e-10) << "t " << t << " wheel " << j;
        EXPECT_WITHIN(u[w + j], speed * railSlope(track, s), speed * (inside == 0.0 ? 5e-14 : 4e-9))
            << "t " << t << " wheel " << j;
      }
    }
  }
}

TEST(Excitation, AnyTrackIsTheProfileOverDistanceUnderEveryWheel) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    for (const History history : {History::kOnset, History::kExtended}) {
      expectTrack(anyTrack(history, seed), paperTopology(), 20.0, 5.0);
      expectTrack(anyTrack(history, seed + 100), topologyOf(test::asymmetricVehicle()), 37.3, 2.7);
    }
  }
}

TEST(Excitation, HeightIsContinuousAtEveryBreakpoint) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const History history = seed % 2 == 0 ? History::kOnset : History::kExtended;
    const Input input = inputOf(scenarioOf(anyTrack(history, seed), 5.0), paperTopology(), 20.0);
    std::vector<double> before(8), after(8);
    ASSERT_GT(input.segments(), 40);
    for (int i = 1; i < input.segments(); ++i) {
      input.evaluate(i - 1, input.segment(i).begin, before);
      input.evaluate(i, input.segment(i).begin, after);
      // Rounding of the breakpoint's time, 1e-15 s, at rates up to 2 m/s.
      for (std::size_t j = 0; j < 4; ++j) EXPECT_WITHIN(before[j], after[j], 5e-15) << "breakpoint " << i;
    }
  }
}

TEST(Excitation, AccelerationsAreDerivativesOfRates) {
  const Input input = inputOf(scenarioOf(anyTrack(History::kOnset, 3), 3.0), paperTopology(), 20.0);
  const double h = 2e-4;
  std::vector<double> u(12), a(8), b(8), c(8), d(8);
  for (int i = 0; i < input.segments(); ++i) {
    const double t = 0.5 * (input.segment(i).begin + input.segment(i).end);
    input.evaluate(i, t, u);
    input.evaluate(i, t - 2 * h, a);
    input.evaluate(i, t - h, b);
    input.evaluate(i, t + h, c);
    input.evaluate(i, t + 2 * h, d);
    for (std::size_t j = 4; j < 8; ++j) {
      const double difference = (8.0 * (c[j] - b[j]) - (d[j] - a[j])) / (12.0 * h);
      // Truncation h^4 w^6 a / 30 at w up to 2 pi 20 / 0.6 = 200 rad/s and 5 mm: 2e-5 m/s^2 of 200.
      EXPECT_WITHIN(u[4 + j], difference, 5e-5) << "segment " << i << " wheel " << j - 4;
    }
  }
}

// ---- one feature at a time

TEST(Excitation, OneMinusCosineDipIsThereForItsLengthUnderEachWheel) {
  Track track;
  track.dips = {dip(DipShape::kOneMinusCosine, 10e-3, 4.0, 20.0)};
  const Input input = inputOf(scenarioOf(track, 5.0), paperTopology(), 20.0);
  // Wheels at 0, 3, 7.45, 10.45 m behind the leader: in from 1 s on, out 0.2 s later.
  const std::vector<double> expected{1.0, 1.15, 1.2, 1.35, 1.3725, 1.5225, 1.5725, 1.7225};
  const std::vector<double> breakpoints = breakpointsOf(input);
  ASSERT_EQ(breakpoints.size(), expected.size());
  for (std::size_t i = 0; i < breakpoints.size(); ++i) EXPECT_DOUBLE_EQ(breakpoints[i], expected[i]);
  std::vector<double> u(8);
  input.evaluate(1, 1.1, u);
  EXPECT_WITHIN(u[0], -10e-3, 1e-17);  // the bottom; rounding
  EXPECT_EQ(u[1], 0.0);
}

// Axles 3 m apart and a half sine of 3 m: the second axle enters as the first one leaves, at 1.15 s up to rounding.
TEST(Excitation, BreakpointsOfTwoWheelsAtOneInstantAreOne) {
  Track track;
  track.dips = {dip(DipShape::kHalfSine, 10e-3, 3.0, 20.0)};
  const Input input = inputOf(scenarioOf(track, 5.0), paperTopology(), 20.0);
  EXPECT_EQ(breakpointsOf(input).size(), 6u);
  // Between samples as well (step 1 s), where nothing but their closeness joins them.
  Scenario coarse = scenarioOf(track, 5.0);
  coarse.run.output_step = 1.0;
  coarse.track->dips[0].start = 20.7;
  EXPECT_EQ(breakpointsOf(inputOf(coarse, paperTopology(), 20.0)).size(), 6u);
}

TEST(Excitation, BreakpointOnAnOutputSampleIsThatSampleBitForBit) {
  Track track;
  track.dips = {dip(DipShape::kHalfSine, 10e-3, 1.0, 14.6)};
  for (const double speed : {20.0, 7.3, 14.6}) {
    const std::vector<double> breakpoints = breakpointsOf(inputOf(scenarioOf(track, 4.0), paperTopology(), speed));
    int samples = 0;
    for (const double breakpoint : breakpoints) {
      const double index = std::round(breakpoint / 5e-3);
      if (std::abs(breakpoint - index * 5e-3) > 5e-12) continue;
      ++samples;
      EXPECT_EQ(breakpoint, index * 5e-3) << speed;
    }
    EXPECT_GE(samples, 1) << speed;
  }
}

TEST(Excitation, BreakpointsOutsideTheRunAreNoBreakpoints) {
  Track track;
  track.history = History::kExtended;
  track.dips = {dip(DipShape::kHalfSine, 10e-3, 1.0, -40.0),   // behind the vehicle
                dip(DipShape::kHalfSine, 10e-3, 5.0, 100.0),   // begins as the run ends
                dip(DipShape::kHalfSine, 10e-3, 40.0, -20.0),  // all wheels are in it at t = 0
                dip(DipShape::kHalfSine, 0.0, 5.0, 50.0)};     // no dip at all
  track.ramps = {ramp(1e-3, 5.0, 1e5)};
  const std::vector<double> breakpoints = breakpointsOf(inputOf(scenarioOf(track, 5.0), paperTopology(), 20.0));
  ASSERT_EQ(breakpoints.size(), 4u);  // the wheels leave the third dip at s = 20
  EXPECT_DOUBLE_EQ(breakpoints[0], 1.0);
}

TEST(Excitation, ExtendedHistoryMayStartInsideADipAndOnTopOfARamp) {
  Track track;
  track.history = History::kExtended;
  track.dips = {dip(DipShape::kHalfSine, 10e-3, 6.0, -3.0)};
  track.ramps = {ramp(30e-3, 4.0, -60.0), ramp(8e-3, 4.0, -2.0)};
  const Input input = inputOf(scenarioOf(track, 5.0), paperTopology(), 20.0);
  std::vector<double> u(8);
  input.evaluate(0, 0.0, u);
  // First wheel: bottom of the dip, top of the first ramp, middle of the second. Rounding of 34 mm.
  EXPECT_WITHIN(u[0], -10e-3 + 30e-3 + 4e-3, 1e-16);
  EXPECT_WITHIN(u[4], 20.0 * 8e-3 / 4.0, 1e-16);
  EXPECT_WITHIN(u[3], 30e-3, 1e-16);  // the last wheel, 10.45 m behind, has only the first ramp under it
  input.evaluate(input.segments() - 1, 5.0, u);
  for (std::size_t j = 0; j < 4; ++j) EXPECT_WITHIN(u[j], 38e-3, 1e-16);
}

TEST(Excitation, FadeInIsThreeSinusoidsAndEndsInABreakpointPerWheel) {
  Scenario scenario = test::paperScenario(History::kOnset);
  scenario.track->fade_in = 50.0;
  scenario.track->harmonics = {test::harmonic(25.0, 1.0, 5e-3, 1.0)};
  const Input input = inputOf(scenario, paperTopology(), 20.0);
  EXPECT_EQ(breakpointsOf(input).size(), 3u + 4u);  // arrivals at s = 0, arrivals at s = 50 m
  EXPECT_EQ(input.segment(3).angular_frequency.size(), 3u);
  EXPECT_EQ(input.segment(7).angular_frequency.size(), 1u);
  std::vector<double> u(12);
  input.evaluate(0, 0.0, u);
  EXPECT_WITHIN(u[0], 0.0, 2e-18);   // cancellation of three terms of 2.5 mm
  EXPECT_WITHIN(u[4], 0.0, 2e-17);   // times w = 5 rad/s
  expectTrack(*scenario.track, paperTopology(), 20.0, 6.0);
}

// fade_in = half the wavelength: one of the three sinusoids stands still.
TEST(Excitation, FadeInOverHalfAWavelengthIsStillExact) {
  Track track;
  track.fade_in = 12.5;
  track.harmonics = {test::harmonic(25.0, 1.0, 5e-3, 0.8), test::harmonic(60.0, 1.0, 5e-3, 2.0)};
  expectTrack(track, paperTopology(), 20.0, 3.0);
}

// A phase error of 1e-16 w t is all that time may cost: 20 000 s at 15 rad/s.
TEST(Excitation, PhaseStaysTrueOnALongRun) {
  Track track;
  track.dips = {dip(DipShape::kHalfSine, 10e-3, 1.0, 399'000.0)};
  track.harmonics = {test::harmonic(25.0, 3.0, 2e-3)};
  Scenario scenario = scenarioOf(track, 20'000.0);
  scenario.run.output_step = 1.0;
  const Input input = inputOf(scenario, paperTopology(), 20.0);
  std::vector<double> u(8);
  for (int i = input.segments() - 8; i < input.segments(); ++i) {
    const double t = 0.5 * (input.segment(i).begin + input.segment(i).end);
    input.evaluate(i, t, u);
    for (std::size_t j = 0; j < 4; ++j) {
      const double s = 20.0 * t - lagOf(paperTopology(), j);
      // 3 ulp of 4e5 m (6e-11 m) at slopes up to 0.03.
      EXPECT_WITHIN(u[j], railHeight(track, s), 5e-12);
    }
  }
}

TEST(Excitation, ThousandDipsCostOnlyTheTermsThatAreAlive) {
  Track track;
  track.harmonics = {test::harmonic(25.0, 1.0, 5e-3)};
  for (int i = 0; i < 1000; ++i) track.dips.push_back(dip(DipShape::kHalfSine, 1e-3, 0.5 + 1e-4 * i, 7.0 + i));
  for (int i = 0; i < 1000; ++i) track.ramps.push_back(ramp(i % 2 == 0 ? 1e-3 : -1e-3, 0.3, 7.6 + i));
  const Input input = inputOf(scenarioOf(track, 60.0), paperTopology(), 20.0);
  EXPECT_GT(input.segments(), 10'000);  // 16 000 breakpoints, of which axles 3 m apart share many
  for (int i = 0; i < input.segments(); ++i) EXPECT_LE(input.segment(i).angular_frequency.size(), 5u);
  std::vector<double> u(8);
  input.evaluate(input.segments() - 1, 59.9, u);
  const double expected = 5e-3 * std::sin(2 * std::numbers::pi * 59.9 * 20.0 / 25.0);
  EXPECT_WITHIN(u[0], expected, 1e-15);  // a thousand ramps that cancel: 1000 roundings of 1 mm at most
}

}  // namespace
}  // namespace vehicle
