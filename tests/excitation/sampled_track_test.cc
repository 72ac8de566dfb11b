// Rails without a closed form over time: known by samples, or passed at a changing speed.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/excitation/excitation.h"
#include "libvehicle/system/mixed_input.h"
#include "libvehicle/system/schedule.h"
#include "libvehicle/track/rail_piece.h"
#include "libvehicle/track/rail_profile.h"
#include "tests/excitation/topologies.h"
#include "tests/support/tolerance.h"
#include "tests/support/tracks.h"

namespace vehicle {
namespace {

using test::paperTopology;

constexpr double kSpeed = 20.0;

double lagOf(const Topology& topology, std::size_t wheel) {
  double lead = topology.wheelsets[0].x;
  for (const TopologyWheelset& each : topology.wheelsets) lead = std::max(lead, each.x);
  return lead - topology.wheelsets[wheel].x;
}

/// A rail from s = 0 m on, of a wave of 10 m and 2 mm.
constexpr double kWave = 2.0 * std::numbers::pi / 10.0, kAmplitude = 2e-3;
std::shared_ptr<const SampledRail> sampledWave(double begin, double spacing, std::size_t count) {
  std::vector<double> heights(count);
  for (std::size_t i = 0; i < count; ++i) {
    heights[i] = kAmplitude * std::sin(kWave * (begin + static_cast<double>(i) * spacing));
  }
  return std::make_shared<SampledRail>(std::make_shared<StoredSamples>(std::move(heights)),
                                       SampleGridOverDistance{begin, spacing});
}

// Each wheel is on its own place of the wave. Allowed: the error of the spline (sampled_rail.h), d^4 k^4 / 384 of the
// height, sqrt(3) d^3 k^4 / 216 V of the rate, d^2 k^4 / 12 V^2 of the acceleration, and 2 % for the next order.
TEST(SampledTrack, EveryWheelReadsAtItsOwnPlace) {
  const double d = 0.25;
  const Topology topology = paperTopology();
  const Input input = inputOf(piecesOf(sampledWave(-50.0, d, 2000)), topology, Travel(kSpeed), {10.0, 5e-3});
  const std::size_t w = 4;
  EXPECT_EQ(input.segments(), 1);
  EXPECT_EQ(input.segment(0).sampled.size(), w);
  std::vector<double> u(3 * w);
  for (double t = 0.0; t < 10.0; t += 0.0137) {
    input.evaluate(0, t, u);
    for (std::size_t j = 0; j < w; ++j) {
      const double phase = kWave * (kSpeed * t - lagOf(topology, j));
      const double steep = kAmplitude * std::pow(kWave, 4);
      EXPECT_WITHIN(u[j], kAmplitude * std::sin(phase), 1.02 * steep * std::pow(d, 4) / 384.0);
      EXPECT_WITHIN(u[w + j], kAmplitude * kWave * kSpeed * std::cos(phase),
                    1.02 * steep * std::sqrt(3.0) / 216.0 * std::pow(d, 3) * kSpeed);
      EXPECT_WITHIN(u[2 * w + j], -kAmplitude * std::pow(kWave * kSpeed, 2) * std::sin(phase),
                    1.02 * steep / 12.0 * d * d * kSpeed * kSpeed);
    }
  }
}

// Level before the samples and behind them; each wheel meets both ends at its own time, where the slope jumps.
TEST(SampledTrack, EndsAreBreakpointsOfEachWheelAndTheHeightIsContinuousThere) {
  const Topology topology = paperTopology();
  const auto rail = sampledWave(3.1, 0.25, 100);
  const Input input = inputOf(piecesOf(rail), topology, Travel(kSpeed), {5.0, 5e-3});
  const std::vector<double> breakpoints = breakpointsOf(input);
  ASSERT_EQ(breakpoints.size(), 8u);
  std::vector<double> expected;
  for (std::size_t j = 0; j < 4; ++j) {
    expected.push_back((rail->begin() + lagOf(topology, j)) / kSpeed);
    expected.push_back((rail->end() + lagOf(topology, j)) / kSpeed);
  }
  std::sort(expected.begin(), expected.end());
  for (std::size_t i = 0; i < 8; ++i) EXPECT_WITHIN(breakpoints[i], expected[i], 5e-12);  // kSameInstant of 5 ms
  std::vector<double> left(8), right(8);
  double largest_jump = 0.0;
  for (int i = 1; i < input.segments(); ++i) {
    input.evaluate(i - 1, input.segment(i).begin, left);
    input.evaluate(i, input.segment(i).begin, right);
    for (std::size_t j = 0; j < 4; ++j) EXPECT_WITHIN(left[j], right[j], 2e-17 + 1.3e-3 * kSpeed * 5e-12);
    for (std::size_t j = 4; j < 8; ++j) largest_jump = std::max(largest_jump, std::abs(left[j] - right[j]));
  }
  EXPECT_GT(largest_jump, 1e-3);
}

TEST(SampledTrack, SweepAndRowsGiveTheSameBitsAndThoseOfEvaluate) {
  const Input input = inputOf(piecesOf(sampledWave(-50.0, 0.25, 2000)), paperTopology(), Travel(kSpeed), {10.0, 5e-3});
  const double t0 = 0.3, dt = 0.5e-3;
  const int count = 1000;
  std::vector<double> rows(8 * static_cast<std::size_t>(count));
  input.sweep(0, t0, dt, count, rows);
  PhasorTable clock;
  input.prepare(0, t0, dt, 0, count, clock);
  std::vector<double> u(8), part(4);
  for (int i = 0; i < count; ++i) {
    const double* row = rows.data() + 8 * i;
    input.evaluate(0, t0 + i * dt, u);
    for (std::size_t k = 0; k < 8; ++k) ASSERT_EQ(row[k], u[k]) << i;
    input.readRow(clock, i, 1, 3, part.data());
    ASSERT_EQ(part, (std::vector<double>{row[1], row[2], row[5], row[6]})) << i;
  }
}

TEST(SampledTrack, ReorderedAndMixedInputsReadTheSameRail) {
  const Input input = inputOf(piecesOf(sampledWave(-50.0, 0.25, 2000)), paperTopology(), Travel(kSpeed), {10.0, 5e-3});
  const std::vector<int> order = {2, 0, 3, 1};
  const Input reordered = input.inOrder(order);
  const Input mixed = mixedInput(input, std::vector<double>{0.25, 0.25, 0.25, 0.25, 0.0, 0.5, -0.5, 0.0});
  std::vector<double> u(12), v(12), m(6);
  for (double t = 0.1; t < 10.0; t += 0.31) {
    input.evaluate(0, t, u);
    reordered.evaluate(0, t, v);
    mixed.evaluate(0, t, m);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t j = 0; j < 4; ++j) EXPECT_EQ(v[4 * k + j], u[4 * k + static_cast<std::size_t>(order[j])]);
      const double* z = u.data() + 4 * k;
      const double size = std::abs(z[0]) + std::abs(z[1]) + std::abs(z[2]) + std::abs(z[3]);
      EXPECT_WITHIN(m[2 * k], 0.25 * (z[0] + z[1] + z[2] + z[3]), 4e-16 * size);
      EXPECT_WITHIN(m[2 * k + 1], 0.5 * (z[1] - z[2]), 4e-16 * size);
    }
  }
}

// A million samples under four wheels: one segment between ends, one term a wheel, and points of measurement as close as the
// shortest wave that the spline follows, four samples, asks for.
TEST(SampledTrack, AMillionSamplesAreOneSegment) {
  const double d = 0.25;
  const Input input = inputOf(piecesOf(sampledWave(0.0, d, 1'000'000)), paperTopology(), Travel(50.0), {4990.0, 5e-3});
  EXPECT_EQ(input.segments(), 4);  // of which three are the arrivals of the wheels at s = 0
  const Schedule schedule(input, Sampling{.output_step = 5e-3});
  EXPECT_LE(schedule.parts().size(), 4u);
  const double points_a_second = schedule.cut() / 5e-3;
  EXPECT_GE(points_a_second, kPointsPerTurn * 50.0 / (4.0 * d));
  EXPECT_LT(points_a_second, 2.0 * kPointsPerTurn * 50.0 / (4.0 * d));
}

// Braked from 20 m/s at 1 m/s^2, then on at 15 m/s, over a harmonic, a dip and a ramp. Against the profile over distance, whose
// slope and bend are differenced here over 0.1 mm: 1e-8 (0.1 mm)^2 k^2 relative, and rounding 1e-17 / 1e-4 of slopes.
TEST(ChangingSpeed, EveryWheelReadsTheRailWhereItIs) {
  Track track;
  track.history = History::kExtended;
  track.harmonics = {test::harmonic(10.0, 1.0, 2e-3)};
  track.dips = {test::dip(DipShape::kOneMinusCosine, 5e-3, 8.0, 30.0)};
  track.ramps = {test::ramp(20e-3, 15.0, 60.0)};
  const Topology topology = paperTopology();
  const Travel travel(20.0, std::vector<Travel::Phase>{{5.0, -1.0}});
  const Input input = inputOf(piecesOf(track), topology, travel, {8.0, 5e-3});
  std::vector<double> u(12);
  const std::vector<double> breakpoints = breakpointsOf(input);
  // Where the acceleration jumps, and each end of dip and ramp under each wheel.
  EXPECT_EQ(breakpoints.size(), 1u + 4u * 4u);
  EXPECT_EQ(std::count(breakpoints.begin(), breakpoints.end(), 5.0), 1);
  for (int i = 0; i < input.segments(); ++i) {
    const InputSegment& segment = input.segment(i);
    for (const double share : {0.1, 0.5, 0.9}) {
      const double t = segment.begin + share * (segment.end - segment.begin);
      input.evaluate(i, t, u);
      const double v = t < 5.0 ? 20.0 - t : 15.0, a = t < 5.0 ? -1.0 : 0.0;
      const double way = t < 5.0 ? 20.0 * t - 0.5 * t * t : 87.5 + 15.0 * (t - 5.0);
      for (std::size_t j = 0; j < 4; ++j) {
        const double s = way - lagOf(topology, j);
        constexpr double kStep = 1e-4;
        const double bend = (railSlope(track, s + kStep) - railSlope(track, s - kStep)) / (2.0 * kStep);
        EXPECT_WITHIN(u[j], railHeight(track, s), 1e-16);
        EXPECT_WITHIN(u[4 + j], railSlope(track, s) * v, 1e-14);
        EXPECT_WITHIN(u[8 + j], bend * v * v + railSlope(track, s) * a, 1e-7);
      }
    }
  }
}

}  // namespace
}  // namespace vehicle
