#include "libvehicle/study/evaluate/column_statistic.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <stdexcept>

#include <gtest/gtest.h>

#include "libvehicle/study/evaluate/steady_statistic.h"
#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

Metric metricOf(const std::string& name) { return parseMetric("carbody.az." + name).metric.value(); }

/// 1.5 + 3 sin(2 pi 2 t) + 0.5 cos(2 pi 7 t), sampled over whole periods.
std::vector<double> twoTones(int samples, double step) {
  std::vector<double> values;
  for (int i = 0; i < samples; ++i) {
    const double t = 2.0 * std::numbers::pi * i * step;
    values.push_back(1.5 + 3.0 * std::sin(2.0 * t) + 0.5 * std::cos(7.0 * t));
  }
  return values;
}

// Closed forms of a sum of sines over whole periods; 1e-13: sums of 2000 roundings of values of size 5.
TEST(ColumnStatistic, OfTwoTonesIsTheClosedForm) {
  ColumnStatistic statistic;
  const double step = 1e-3;
  const std::vector<double> x = twoTones(2001, step);  // the last sample ends the last period
  const std::span<const double> periods = std::span(x).first(2000);
  EXPECT_WITHIN(statistic(metricOf("mean"), periods, step), 1.5, 1e-13);
  EXPECT_WITHIN(statistic(metricOf("rms"), periods, step), std::sqrt(1.5 * 1.5 + 4.5 + 0.125), 1e-13);
  EXPECT_WITHIN(statistic(metricOf("band(1..3 Hz)"), x, step), 3.0 / std::numbers::sqrt2, 1e-13);
  EXPECT_WITHIN(statistic(metricOf("band(5..9 Hz)"), x, step), 0.5 / std::numbers::sqrt2, 1e-13);
  EXPECT_WITHIN(statistic(metricOf("band(0..1 Hz)"), x, step), 1.5, 1e-13);
  EXPECT_WITHIN(statistic(metricOf("band(10..400 Hz)"), x, step), 0.0, 1e-12);
}

// Parseval: bands that share no line add up to the mean square, whatever the signal; roundings of 1001 x 501 products.
TEST(ColumnStatistic, BandsAddUpToTheMeanSquare) {
  ColumnStatistic statistic;
  for (const int n : {1001, 1002}) {
    std::vector<double> x;
    for (int i = 0; i < n; ++i) x.push_back(std::sin(0.37 * i) * std::exp(-1e-3 * i) + 1e-4 * ((i * 7919) % 1000));
    double sum = 0.0;
    for (const char* band : {"band(0..3 Hz)", "band(3..20.5 Hz)", "band(20.5..99 Hz)", "band(99..600 Hz)"}) {
      sum += std::pow(statistic(metricOf(band), x, 1e-3), 2);
    }
    const std::span<const double> steps = std::span(x).first(x.size() - 1);  // the last sample ends the last step
    EXPECT_WITHIN(std::sqrt(sum), statistic(metricOf("rms"), steps, 1e-3), 1e-13) << n;
  }
}

TEST(ColumnStatistic, ABandWithoutLineSaysWhy) {
  ColumnStatistic statistic;
  const std::vector<double> x(101, 1.0);
  EXPECT_THROW(static_cast<void>(statistic(metricOf("band(4.1..4.9 Hz)"), x, 0.01)), std::domain_error);
  EXPECT_THROW(static_cast<void>(statistic(metricOf("band(60..70 Hz)"), x, 0.01)), std::domain_error);
  EXPECT_THROW(static_cast<void>(statistic(metricOf("band(1e19 Hz..1e20 Hz)"), x, 0.01)), std::domain_error);
}

TEST(ColumnStatistic, ExtremesAndPercentilesAreThoseOfTheSortedValues) {
  ColumnStatistic statistic;
  std::vector<double> x;
  for (int i = -40; i <= 60; ++i) x.push_back((i * 37 + 4000) % 101 - 40.0);  // -40 .. 60 in disorder
  EXPECT_EQ(statistic(metricOf("min"), x, 1.0), -40.0);
  EXPECT_EQ(statistic(metricOf("max"), x, 1.0), 60.0);
  EXPECT_EQ(statistic(metricOf("peak"), x, 1.0), 60.0);
  EXPECT_EQ(statistic(metricOf("p50"), x, 1.0), 10.0);
  EXPECT_WITHIN(statistic(metricOf("p95.5"), x, 1.0), 55.5, 1e-12);  // between two order statistics, rounding of 0.955
  // |x|: 0 once, 1..40 twice, 41..60 once; the place 0.75 * 100 = 75 is the 76th value, 35 from the top 60..41 + pairs.
  std::vector<double> absolute;
  for (const double each : x) absolute.push_back(std::abs(each));
  std::sort(absolute.begin(), absolute.end());
  EXPECT_EQ(statistic(metricOf("abs_p75"), x, 1.0), absolute[75]);
}

// The same motion told by amplitudes and by samples. 4096 samples, order 7: a parabola misses a peak by
// (2 pi 7 / 4096)^4 / 128, below 1e-9; the percentile by its own spacing, 2 pi 3 / 4096 < 5e-3.
TEST(SteadyStatistic, OfTwoTonesIsTheClosedForm) {
  const std::vector<double> w = {4.0 * std::numbers::pi, 14.0 * std::numbers::pi};
  SteadyStatistic statistic(w);
  const std::vector<std::complex<double>> X = {{0.0, -3.0}, {0.5, 0.0}};
  EXPECT_WITHIN(statistic(metricOf("rms"), 1.5, X), std::sqrt(1.5 * 1.5 + 4.5 + 0.125), 1e-14);
  EXPECT_WITHIN(statistic(metricOf("band(1..3 Hz)"), 1.5, X), 3.0 / std::numbers::sqrt2, 1e-14);
  EXPECT_WITHIN(statistic(metricOf("band(0..3 Hz)"), 1.5, X), std::sqrt(1.5 * 1.5 + 4.5), 1e-14);
  ColumnStatistic sampled;
  const std::vector<double> dense = twoTones(1'000'000, 1e-6);
  EXPECT_WITHIN(statistic(metricOf("max"), 1.5, X), sampled(metricOf("max"), dense, 1e-6), 2e-8);
  EXPECT_WITHIN(statistic(metricOf("min"), 1.5, X), sampled(metricOf("min"), dense, 1e-6), 2e-8);
  EXPECT_WITHIN(statistic(metricOf("p90"), 1.5, X), sampled(metricOf("p90"), dense, 1e-6), 5e-3);
}

TEST(SteadyStatistic, WithoutCommonPeriodThereAreNoPeaks) {
  SteadyStatistic statistic(std::vector<double>{1.0, std::numbers::pi});
  const std::vector<std::complex<double>> X = {1.0, 1.0};
  EXPECT_WITHIN(statistic(metricOf("rms"), 0.0, X), 1.0, 1e-15);  // one rounding
  EXPECT_THROW(static_cast<void>(statistic(metricOf("peak"), 0.0, X)), std::domain_error);
}

}  // namespace
}  // namespace vehicle
