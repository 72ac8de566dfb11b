#include "libvehicle/system/schedule.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace vehicle {
namespace {

// A flat rail under one wheel that is cut at these times: only the cuts matter to a schedule.
Input cutAt(const std::vector<double>& borders) {
  std::vector<InputSegment> segments;
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    InputSegment piece;
    piece.begin = borders[i];
    piece.end = borders[i + 1];
    piece.polynomial.assign(4, 0.0);
    segments.push_back(piece);
  }
  return Input(1, std::move(segments));
}

// What every schedule keeps: intervals join, none is a sliver, samples come in order, the segments hold there.
void expectSound(const Input& input, const Schedule& schedule) {
  const double same = 1e-9 * schedule.outputStep();
  const auto intervals = schedule.intervals();
  double reached = input.begin();
  int sample = 0;
  ASSERT_FALSE(intervals.empty());
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const Interval interval = intervals[i];
    EXPECT_EQ(interval.begin, reached) << "interval " << i;
    EXPECT_GT(interval.end - interval.begin, same) << "interval " << i;
    EXPECT_GE(interval.begin, input.segment(interval.segment).begin - same) << "interval " << i;
    EXPECT_LE(interval.end, input.segment(interval.segment).end + same) << "interval " << i;
    if (interval.sample >= 0) {
      EXPECT_EQ(interval.sample, ++sample);
      EXPECT_EQ(interval.end, schedule.time(sample));
    }
    if (i + 1 < intervals.size()) {
      EXPECT_EQ(interval.next, intervals[i + 1].segment) << "interval " << i;
    }
    reached = interval.end;
  }
  EXPECT_EQ(sample, schedule.samples() - 1);
}

TEST(Schedule, SmoothInputGivesOneIntervalAnOutputStep) {
  const Input input = cutAt({0.0, 10.0});
  const Schedule schedule(input, 5e-3);
  EXPECT_EQ(schedule.samples(), 2001);
  EXPECT_EQ(schedule.intervals().size(), 2000u);
  EXPECT_EQ(schedule.intervals().back().end, 10.0);
  expectSound(input, schedule);
}

// (5.225 - 2.225)/20 = 0.14999999999999997 while 30 * 5 ms = 0.15: compared as times they leave 3e-17 s.
TEST(Schedule, BreakpointThatIsASampleUpToRoundingLeavesNoSliver) {
  const double breakpoint = (5.225 - 2.225) / 20.0;
  ASSERT_NE(breakpoint, 30 * 5e-3);
  const Input input = cutAt({0.0, breakpoint, 0.3});
  const Schedule schedule(input, 5e-3);
  EXPECT_EQ(schedule.samples(), 61);
  ASSERT_EQ(schedule.intervals().size(), 60u);
  const Interval before = schedule.intervals()[29];
  EXPECT_EQ(before.sample, 30);
  EXPECT_EQ(before.end, breakpoint);
  EXPECT_EQ(before.segment, 0);
  EXPECT_EQ(before.next, 1);
  EXPECT_EQ(schedule.intervals()[30].segment, 1);
  expectSound(input, schedule);
}

TEST(Schedule, BreakpointBetweenSamplesCutsTheInterval) {
  const Input input = cutAt({0.0, 0.1234, 1.0});
  const Schedule schedule(input, 0.1);
  ASSERT_EQ(schedule.intervals().size(), 11u);
  EXPECT_EQ(schedule.intervals()[1].end, 0.1234);
  EXPECT_EQ(schedule.intervals()[1].sample, -1);
  EXPECT_EQ(schedule.intervals()[2].sample, 2);
  EXPECT_EQ(schedule.intervals()[2].segment, 1);
  expectSound(input, schedule);
}

TEST(Schedule, ManyBreakpointsBetweenTwoSamples) {
  std::vector<double> borders{0.0};
  for (int i = 1; i < 500; ++i) borders.push_back(borders.back() + 0.7e-3 + 1e-4 * std::sin(i));
  borders.push_back(1.0);
  const Input input = cutAt(borders);
  const Schedule schedule(input, 0.25);
  EXPECT_EQ(schedule.samples(), 5);
  EXPECT_EQ(schedule.intervals().size(), 499u + 4u);
  expectSound(input, schedule);
}

TEST(Schedule, OutputStepLongerThanEverySegment) {
  const Input input = cutAt({0.0, 0.1, 0.2, 0.3, 0.4, 1.0});
  const Schedule schedule(input, 0.5);
  EXPECT_EQ(schedule.samples(), 3);
  EXPECT_EQ(schedule.intervals().size(), 6u);
  expectSound(input, schedule);
}

TEST(Schedule, BreakpointsAtTheStartAndAtTheEndAreNoIntervals) {
  const double sliver = 1e-13;
  const Input input = cutAt({0.0, sliver, 1.0 - sliver, 1.0});
  const Schedule schedule(input, 0.1);
  EXPECT_EQ(schedule.samples(), 11);
  ASSERT_EQ(schedule.intervals().size(), 10u);
  EXPECT_EQ(schedule.intervals().front().segment, 1);
  EXPECT_EQ(schedule.intervals().front().begin, 0.0);
  EXPECT_EQ(schedule.intervals().back().segment, 1);
  EXPECT_EQ(schedule.intervals().back().next, 2);
  expectSound(input, schedule);
}

TEST(Schedule, BreakpointsCloserThanABillionthOfAStepAreOne) {
  const Input input = cutAt({0.0, 0.1234, 0.1234 + 5e-11, 0.3 - 5e-11, 0.3 + 3e-11, 1.0});
  const Schedule schedule(input, 0.1);
  EXPECT_EQ(schedule.intervals().size(), 11u);
  EXPECT_EQ(schedule.intervals()[2].segment, 2);
  EXPECT_EQ(schedule.intervals()[3].end, 0.3 - 5e-11);
  EXPECT_EQ(schedule.intervals()[3].next, 4);
  expectSound(input, schedule);
}

TEST(Schedule, TheLastSampleIsTheEndOfTheRunWhereverThatLies) {
  const Input input = cutAt({2.0, 2.97, 3.03});
  const Schedule schedule(input, 0.1);
  EXPECT_EQ(schedule.samples(), 12);
  EXPECT_EQ(schedule.outputs(), 12);
  const Interval last = schedule.intervals().back();
  EXPECT_EQ(last.sample, 11);
  EXPECT_EQ(last.output, 11);
  EXPECT_EQ(last.regular, -1);
  EXPECT_EQ(last.begin, 3.0);
  EXPECT_EQ(last.end, 3.03);
  EXPECT_EQ(schedule.time(0), 2.0);
  EXPECT_EQ(schedule.time(11), 3.03);
  expectSound(input, schedule);
}

// 0.3 / 0.1 = 2.9999999999999996: the last sample must not be lost to rounding.
TEST(Schedule, DurationThatIsAMultipleUpToRoundingKeepsItsLastSample) {
  for (const double step : {0.1, 0.05, 1e-3, 5e-3, 7e-3}) {
    for (const int n : {3, 6, 7, 1000, 9999}) {
      const Input input = cutAt({0.0, n * step});
      EXPECT_EQ(Schedule(input, step).samples(), n + 1) << step << " s x " << n;
      const Input rounded = cutAt({0.0, std::nextafter(n * step, 0.0)});
      const Schedule schedule(rounded, step);
      EXPECT_EQ(schedule.samples(), n + 1) << step << " s x " << n;
      EXPECT_LE(schedule.intervals().back().end, rounded.end());
    }
  }
}

TEST(Schedule, RefusesStepsThatMakeNoSamplesOrTooMany) {
  const Input input = cutAt({0.0, 1.0});
  EXPECT_THROW(Schedule(input, 0.0), std::invalid_argument);
  EXPECT_THROW(Schedule(input, -1.0), std::invalid_argument);
  EXPECT_THROW(Schedule(input, std::nan("")), std::invalid_argument);
  EXPECT_THROW(Schedule(input, 1e-8), std::invalid_argument);
  EXPECT_EQ(Schedule(input, 1.0).samples(), 2);
  try {
    const Schedule schedule(input, 1.5);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "Schedule: an input of 1 s is 0 output steps of 1.5 s, must be 1..10000000");
  }
}

TEST(SampleAt, NamesASampleOnlyWithinABillionthOfAStep) {
  EXPECT_EQ(sampleAt(0.0, 5e-3, (5.225 - 2.225) / 20.0), 30);
  EXPECT_EQ(sampleAt(0.0, 5e-3, 0.15 + 4e-12), 30);
  EXPECT_EQ(sampleAt(0.0, 5e-3, 0.15 + 6e-12), -1);
  EXPECT_EQ(sampleAt(0.0, 5e-3, -5e-3), -1);
  EXPECT_EQ(sampleAt(-5e-3, 5e-3, 0.0), 1);
  EXPECT_EQ(sampleAt(0.0, 5e-3, 1e300), -1);
}

// 3 * 0.1 is one rounding above the double nearest to 0.3.
TEST(SampleGrid, TimesOfADecimalStepAreTheDoublesNearestToTheDecimals) {
  EXPECT_NE(3 * 0.1, 0.3);
  EXPECT_EQ(SampleGrid(0.0, 0.1).time(3), 0.3);
  EXPECT_EQ(SampleGrid(0.0, 0.005).time(7), 0.035);
  EXPECT_EQ(SampleGrid(0.0, 5.7).time(631), 3596.7);
  // Points between them never move the samples themselves.
  for (const int cut : {2, 3, 7, 20}) {
    for (int i = 0; i < 1000; ++i) {
      ASSERT_EQ(SampleGrid(0.0, 0.005).time(std::int64_t{i} * cut, cut), SampleGrid(0.0, 0.005).time(i)) << cut;
    }
  }
  EXPECT_EQ(SampleGrid(0.0, 1.0 / 3.0).time(3), 3 * (1.0 / 3.0));
}

/// A rail of one harmonic in each of these intervals.
Input wavesAt(const std::vector<double>& borders, const std::vector<double>& angular_frequencies) {
  std::vector<InputSegment> segments;
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    InputSegment piece;
    piece.begin = borders[i];
    piece.end = borders[i + 1];
    piece.polynomial.assign(4, 0.0);
    piece.angular_frequency = {angular_frequencies[i]};
    piece.cosine = {0.0};
    piece.sine = {1e-3};
    segments.push_back(piece);
  }
  return Input(1, std::move(segments));
}

TEST(MeasuredSchedule, CutsOutputStepsByTheFastestMotionOfTheSystem) {
  const Input input = cutAt({0.0, 1.0});
  for (const double fastest : {10.0, 62.0, 63.0, 1257.0}) {
    const Schedule schedule(input, Sampling{.output_step = 5e-3, .fastest = fastest});
    const double turn = 2.0 * std::numbers::pi / fastest;
    const double apart = 5e-3 / schedule.cut();
    EXPECT_LE(apart, turn / kPointsPerTurn * (1.0 + 1e-5)) << fastest;
    EXPECT_GT(schedule.cut() == 1 ? HUGE_VAL : 5e-3 / (schedule.cut() - 1), turn / kPointsPerTurn) << fastest;
    EXPECT_EQ(schedule.outputs(), 201);
    EXPECT_EQ(schedule.samples(), 200 * schedule.cut() + 1);
    int output = 0;
    for (const Interval interval : schedule.intervals()) {
      if (interval.output < 0) continue;
      EXPECT_EQ(interval.output, ++output);
      EXPECT_EQ(interval.end, SampleGrid(0.0, 5e-3).time(output));
    }
    EXPECT_EQ(output, 200);
    expectSound(input, schedule);
  }
}

// A bump of a millisecond is followed by itself; the run around it is not.
TEST(MeasuredSchedule, FollowsAPassingBumpWhileItLastsAndALastingWaveAllTheTime) {
  const double bump = std::numbers::pi / 1e-3;
  const Input passing = wavesAt({0.0, 0.5021, 0.5031, 1.0}, {3.0, bump, 3.0});
  const Schedule around(passing, Sampling{.output_step = 5e-3, .fastest = 10.0});
  EXPECT_EQ(around.cut(), 1);
  EXPECT_LT(around.samples(), 201 + 2 + 30);
  for (const Interval interval : around.intervals()) {
    if (interval.segment != 1) continue;
    EXPECT_LE(interval.end - interval.begin, 2.0 * std::numbers::pi / bump / kPointsPerTurn * 1.001);
  }
  const Input lasting = wavesAt({0.0, 1.0}, {bump});
  EXPECT_EQ(Schedule(lasting, Sampling{.output_step = 5e-3, .fastest = 10.0}).cut(), 50);
}

TEST(MeasuredSchedule, SeesBothSidesOfEveryBreakpoint) {
  const Input input = cutAt({0.0, 0.1234, 0.25, 1.0});
  const Schedule schedule(input, Sampling{.output_step = 0.05});
  EXPECT_EQ(schedule.samples(), 22);
  EXPECT_EQ(schedule.outputs(), 21);
  EXPECT_EQ(schedule.intervals()[2].sample, 3);
  EXPECT_EQ(schedule.intervals()[2].end, 0.1234);
  EXPECT_EQ(schedule.intervals()[2].output, -1);
  EXPECT_EQ(schedule.intervals()[2].next, 1);
  EXPECT_EQ(schedule.time(3), 0.1234);
  expectSound(input, schedule);
}

TEST(MeasuredSchedule, SamplesEndFixedSteps) {
  const Input input = cutAt({0.0, 1.0});
  for (const int steps : {1, 5, 6, 7, 12}) {
    const Schedule schedule(input, Sampling{.output_step = 5e-3, .fastest = 150.0, .steps = steps});  // 2.4 points
    EXPECT_EQ(steps % schedule.cut(), 0) << steps;
    EXPECT_EQ(schedule.isResolved(), schedule.cut() >= 3) << steps;
  }
}

TEST(MeasuredSchedule, CountsFromAnOutputSampleOn) {
  const Input input = cutAt({0.0, 0.27, 1.0});
  const Schedule schedule(input, Sampling{.output_step = 0.1, .count_from = 0.3});
  double counted = 0.0;
  for (const Schedule::Part& part : schedule.parts()) counted += part.counts ? part.end - part.begin : 0.0;
  EXPECT_DOUBLE_EQ(counted, 0.7);
  ASSERT_EQ(schedule.parts().size(), 3u);
  EXPECT_EQ(schedule.parts()[1].next, 1);
  expectSound(input, schedule);
}

// What a run keeps of its schedule must not grow with its length: ten million samples, one part.
TEST(Schedule, MemoryGoesWithTheSegments) {
  const Input input = cutAt({0.0, 5e4});
  const Schedule schedule(input, 5e-3);
  EXPECT_EQ(schedule.intervals().size(), 10'000'000u);
  EXPECT_EQ(schedule.parts().size(), 1u);
  EXPECT_EQ(schedule.intervals()[0].alike, 10'000'000u);
  EXPECT_EQ(schedule.intervals()[9'999'999].end, 5e4);
}

}  // namespace
}  // namespace vehicle
