#include "libvehicle/system/schedule.h"

#include <cmath>
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

// What every schedule keeps: stretches join, none is a sliver, samples come in order, the segments hold there.
void expectSound(const Input& input, const Schedule& schedule) {
  const double same = 1e-9 * schedule.outputStep();
  const auto& stretches = schedule.stretches();
  double reached = input.begin();
  int sample = 0;
  ASSERT_FALSE(stretches.empty());
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const Stretch& stretch = stretches[i];
    EXPECT_EQ(stretch.begin, reached) << "stretch " << i;
    EXPECT_GT(stretch.end - stretch.begin, same) << "stretch " << i;
    EXPECT_GE(stretch.begin, input.segment(stretch.segment).begin - same) << "stretch " << i;
    EXPECT_LE(stretch.end, input.segment(stretch.segment).end + same) << "stretch " << i;
    if (stretch.sample >= 0) {
      EXPECT_EQ(stretch.sample, ++sample);
      EXPECT_NEAR(stretch.end, schedule.time(sample), same);
    }
    if (i + 1 < stretches.size()) {
      EXPECT_EQ(stretch.next, stretches[i + 1].segment) << "stretch " << i;
    }
    reached = stretch.end;
  }
  EXPECT_EQ(sample, schedule.samples() - 1);
}

TEST(Schedule, SmoothInputGivesOneStretchAnOutputStep) {
  const Input input = cutAt({0.0, 10.0});
  const Schedule schedule(input, 5e-3);
  EXPECT_EQ(schedule.samples(), 2001);
  EXPECT_EQ(schedule.stretches().size(), 2000u);
  EXPECT_EQ(schedule.stretches().back().end, 10.0);
  expectSound(input, schedule);
}

// (5.225 - 2.225)/20 = 0.14999999999999997 while 30 * 5 ms = 0.15: compared as times they leave 3e-17 s.
TEST(Schedule, KinkThatIsASampleUpToRoundingLeavesNoSliver) {
  const double kink = (5.225 - 2.225) / 20.0;
  ASSERT_NE(kink, 30 * 5e-3);
  const Input input = cutAt({0.0, kink, 0.3});
  const Schedule schedule(input, 5e-3);
  EXPECT_EQ(schedule.samples(), 61);
  ASSERT_EQ(schedule.stretches().size(), 60u);
  const Stretch& before = schedule.stretches()[29];
  EXPECT_EQ(before.sample, 30);
  EXPECT_EQ(before.end, kink);
  EXPECT_EQ(before.segment, 0);
  EXPECT_EQ(before.next, 1);
  EXPECT_EQ(schedule.stretches()[30].segment, 1);
  expectSound(input, schedule);
}

TEST(Schedule, KinkBetweenSamplesCutsTheStretch) {
  const Input input = cutAt({0.0, 0.1234, 1.0});
  const Schedule schedule(input, 0.1);
  ASSERT_EQ(schedule.stretches().size(), 11u);
  EXPECT_EQ(schedule.stretches()[1].end, 0.1234);
  EXPECT_EQ(schedule.stretches()[1].sample, -1);
  EXPECT_EQ(schedule.stretches()[2].sample, 2);
  EXPECT_EQ(schedule.stretches()[2].segment, 1);
  expectSound(input, schedule);
}

TEST(Schedule, ManyKinksBetweenTwoSamples) {
  std::vector<double> borders{0.0};
  for (int i = 1; i < 500; ++i) borders.push_back(borders.back() + 0.7e-3 + 1e-4 * std::sin(i));
  borders.push_back(1.0);
  const Input input = cutAt(borders);
  const Schedule schedule(input, 0.25);
  EXPECT_EQ(schedule.samples(), 5);
  EXPECT_EQ(schedule.stretches().size(), 499u + 4u);
  expectSound(input, schedule);
}

TEST(Schedule, OutputStepLongerThanEverySegment) {
  const Input input = cutAt({0.0, 0.1, 0.2, 0.3, 0.4, 1.0});
  const Schedule schedule(input, 0.5);
  EXPECT_EQ(schedule.samples(), 3);
  EXPECT_EQ(schedule.stretches().size(), 6u);
  expectSound(input, schedule);
}

TEST(Schedule, KinksAtTheStartAndAtTheEndAreNoStretches) {
  const double sliver = 1e-13;
  const Input input = cutAt({0.0, sliver, 1.0 - sliver, 1.0});
  const Schedule schedule(input, 0.1);
  EXPECT_EQ(schedule.samples(), 11);
  ASSERT_EQ(schedule.stretches().size(), 10u);
  EXPECT_EQ(schedule.stretches().front().segment, 1);
  EXPECT_EQ(schedule.stretches().front().begin, 0.0);
  EXPECT_EQ(schedule.stretches().back().segment, 1);
  EXPECT_EQ(schedule.stretches().back().next, 2);
  expectSound(input, schedule);
}

TEST(Schedule, KinksCloserThanABillionthOfAStepAreOne) {
  const Input input = cutAt({0.0, 0.1234, 0.1234 + 5e-11, 0.3 - 5e-11, 0.3 + 3e-11, 1.0});
  const Schedule schedule(input, 0.1);
  EXPECT_EQ(schedule.stretches().size(), 11u);
  EXPECT_EQ(schedule.stretches()[2].segment, 2);
  EXPECT_EQ(schedule.stretches()[3].end, 0.3 - 5e-11);
  EXPECT_EQ(schedule.stretches()[3].next, 4);
  expectSound(input, schedule);
}

TEST(Schedule, RemainderAfterTheLastSampleIsNotRun) {
  const Input input = cutAt({2.0, 2.97, 3.03});
  const Schedule schedule(input, 0.1);
  EXPECT_EQ(schedule.samples(), 11);
  EXPECT_EQ(schedule.stretches().back().sample, 10);
  EXPECT_DOUBLE_EQ(schedule.stretches().back().end, 3.0);
  EXPECT_EQ(schedule.time(0), 2.0);
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
      EXPECT_LE(schedule.stretches().back().end, rounded.end());
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

}  // namespace
}  // namespace vehicle
