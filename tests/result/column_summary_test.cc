#include "libvehicle/result/column_summary.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace vehicle {
namespace {

constexpr double kPi = std::numbers::pi;

/// A sine of that many samples a period, seen at a phase that hides its extremes as well as can be.
ColumnSummary sineSummary(int samples_a_period) {
  const double step = 2.0 * kPi / samples_a_period;
  ColumnSummaries gathered(1);
  for (int i = 0; i <= 10 * samples_a_period; ++i) {
    const std::array<double, 1> y = {3.0 * std::sin(i * step + 0.5 * step + 0.5 * kPi)};
    const double weight = i == 0 || i == 10 * samples_a_period ? 0.5 * step : step;
    i == 0 ? gathered.begin(0.0, weight, y) : gathered.add(i * step, weight, y);
  }
  return gathered.summaries().front();
}

TEST(ColumnSummaries, FindThePeakOfASineBetweenItsSamples) {
  const ColumnSummary summary = sineSummary(20);
  // (2 pi / 20)^4 / 40 = 2.4e-4 for the parabola; the largest sample alone misses 1 - cos(pi / 20) = 1.2e-2.
  EXPECT_NEAR(summary.highest, 3.0, 3.0 * 2.4e-4);
  EXPECT_NEAR(summary.lowest, -3.0, 3.0 * 2.4e-4);
  EXPECT_NEAR(summary.peak(), 3.0, 3.0 * 2.4e-4);
  EXPECT_NEAR(summary.rms, 3.0 / std::sqrt(2.0), 1e-12);  // the trapezoidal rule over whole periods
  EXPECT_NEAR(summary.mean, 0.0, 1e-12);
}

TEST(ColumnSummaries, ErrorOfAPeakFallsWithTheFourthPower) {
  const double ratio = (3.0 - sineSummary(20).highest) / (3.0 - sineSummary(40).highest);
  EXPECT_GT(ratio, 15.0);
  EXPECT_LT(ratio, 17.0);
}

TEST(ColumnSummaries, AParabolaIsFoundExactlyAtUnequalSamples) {
  const auto y = [](double t) { return std::array<double, 1>{2.0 - (t - 0.4) * (t - 0.4)}; };
  ColumnSummaries gathered(1);
  gathered.begin(0.0, 1.0, y(0.0));
  gathered.add(0.3, 1.0, y(0.3));
  gathered.add(0.9, 1.0, y(0.9));
  const ColumnSummary summary = gathered.summaries().front();
  EXPECT_NEAR(summary.highest, 2.0, 1e-15 * 8);
  EXPECT_NEAR(summary.highest_at, 0.4, 1e-15 * 8);
}

// Behind a breakpoint nothing is known of the motion before it: a jump is no parabola.
TEST(ColumnSummaries, AJumpIsNoExtreme) {
  ColumnSummaries gathered(1);
  const auto at = [](double value) { return std::array<double, 1>{value}; };
  gathered.begin(0.0, 0.5, at(1.0));
  gathered.add(1.0, 0.5, at(1.0));
  gathered.begin(1.0, 0.5, at(4.0));
  gathered.add(2.0, 0.5, at(1.0));
  const ColumnSummary summary = gathered.summaries().front();
  EXPECT_EQ(summary.highest, 4.0);
  EXPECT_EQ(summary.highest_at, 1.0);
  EXPECT_EQ(summary.lowest, 1.0);
  EXPECT_DOUBLE_EQ(summary.mean, 0.5 * (1.0 + 2.5));
}

TEST(ColumnSummaries, WithoutASampleEverythingIsZero) { EXPECT_EQ(ColumnSummaries(2).summaries()[1].peak(), 0.0); }

}  // namespace
}  // namespace vehicle
