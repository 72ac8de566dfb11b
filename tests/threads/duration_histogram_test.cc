#include "libvehicle/threads/duration_histogram.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/delays.h"
#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

TEST(DurationHistogram, QuantilesAreThoseOfTheSortedDurationsWithinOneBin) {
  std::vector<std::uint64_t> durations;
  for (std::uint64_t i = 0; i < 5000; ++i) durations.push_back(test::scrambled(i) >> (test::scrambled(i, 1) % 60));
  DurationHistogram histogram;
  for (const std::uint64_t duration : durations) histogram.record(duration);
  std::ranges::sort(durations);
  for (const double p : {0.01, 0.25, 0.5, 0.9, 0.99, 0.999, 1.0}) {
    const auto rank = static_cast<std::size_t>(p * 5000.0 + 0.5);
    const auto truth = static_cast<double>(durations[rank - 1]);
    EXPECT_WITHIN(histogram.quantile(p), truth, truth / 32.0);  // half a bin: 16 bins an octave
  }
  EXPECT_EQ(histogram.most(), durations.back());
}

TEST(DurationHistogram, SmallNumbersAreExact) {
  DurationHistogram histogram;
  for (std::uint64_t ticks = 0; ticks < 32; ++ticks) histogram.record(ticks);
  for (int rank = 1; rank <= 32; ++rank) EXPECT_EQ(histogram.quantile(rank / 32.0), rank - 1) << rank;
}

TEST(DurationHistogram, BinsHoldEveryDurationAndJoin) {
  DurationHistogram histogram;
  long recorded = 0;
  for (std::uint64_t ticks = 1; ticks < (std::uint64_t{1} << 62); ticks += 1 + ticks / 40, ++recorded)
    histogram.record(ticks);
  const DurationSummary summary = histogram.summary(1.0);
  long counted = 0;
  for (std::size_t i = 0; i < summary.bins.size(); ++i) {
    counted += summary.bins[i].count;
    EXPECT_TRUE(i == 0 || summary.bins[i].begin == summary.bins[i - 1].end) << i;
    EXPECT_LE(summary.bins[i].end - summary.bins[i].begin, std::max(1.0, summary.bins[i].begin / 16.0)) << i;
  }
  EXPECT_EQ(counted, recorded);
  EXPECT_EQ(summary.count, recorded);
}

TEST(DurationHistogram, TheSummaryIsInSeconds) {
  DurationHistogram histogram;
  for (const std::uint64_t ticks : {1000u, 2000u, 3000u}) histogram.record(ticks);
  const DurationSummary summary = histogram.summary(1e-9);
  EXPECT_DOUBLE_EQ(summary.least, 1e-6);
  EXPECT_DOUBLE_EQ(summary.mean, 2e-6);
  EXPECT_DOUBLE_EQ(summary.most, 3e-6);
  EXPECT_WITHIN(summary.p50, 2e-6, 2e-6 / 32.0);  // half a bin
}

TEST(DurationHistogram, WithoutDurationsEveryFigureIsZero) {
  EXPECT_EQ(DurationHistogram().quantile(0.5), 0.0);
  EXPECT_EQ(DurationHistogram().summary(1e-9).most, 0.0);
}

TEST(DurationHistogram, TheLongestDurationThatExistsIsCounted) {
  DurationHistogram histogram;
  histogram.record(~std::uint64_t{0});
  EXPECT_EQ(histogram.count(), 1);
  EXPECT_EQ(histogram.quantile(0.5), 18446744073709551615.0);
}

}  // namespace
}  // namespace vehicle
