#include "libvehicle/track/sampled_rail.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/track/rail_piece.h"
#include "tests/support/refusal.h"
#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

using test::refusalOf;

template <class Height>
std::shared_ptr<RailSamples> samplesOf(std::size_t count, SampleGridOverDistance grid, Height height) {
  std::vector<double> heights(count);
  for (std::size_t i = 0; i < count; ++i) heights[i] = height(grid.begin + static_cast<double>(i) * grid.spacing);
  return std::make_shared<StoredSamples>(std::move(heights));
}

/// Counts what is asked of it.
class CountedSamples final : public RailSamples {
 public:
  explicit CountedSamples(std::shared_ptr<RailSamples> samples) : samples_(std::move(samples)) {}
  std::int64_t count() const override { return samples_->count(); }
  void read(std::int64_t first, std::span<double> heights) override {
    ++requests;
    longest = std::max(longest, heights.size());
    samples_->read(first, heights);
  }
  long requests = 0;
  std::size_t longest = 0;

 private:
  std::shared_ptr<RailSamples> samples_;
};

// A spline through a cubic is that cubic, over the borders of blocks too. Rounding: heights up to 0.3 m, known to 4e-17,
// enter a slope over a spacing of 0.25 m and a curvature over its square, each some ten times.
TEST(SampledRail, GivesACubicBackWithSlopeAndCurvature) {
  const SampleGridOverDistance grid{-100.0, 0.25};
  const auto cubic = [](double s) { return 1e-3 - 2e-4 * s + 3e-7 * s * s + 1e-10 * s * s * s; };
  const SampledRail rail(samplesOf(5000, grid, cubic), grid);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(rail.begin(), rail.end());
  for (int i = 0; i < 2000; ++i) {
    const double s = i == 0 ? rail.begin() : i == 1 ? rail.end() : anywhere(random);
    const RailPoint point = rail.at(s);
    EXPECT_WITHIN(point.height, cubic(s), 1e-15);
    EXPECT_WITHIN(point.slope, -2e-4 + 6e-7 * s + 3e-10 * s * s, 4e-15);
    EXPECT_WITHIN(point.curvature, 6e-7 + 6e-10 * s, 3e-14);
  }
}

/// Largest errors of height and slope of a wave of 10 m and 1 mm, sampled over 200 waves from crest to crest.
std::pair<double, double> errorsAt(double spacing) {
  const double k = 2.0 * std::acos(-1.0) / 10.0, a = 1e-3;
  const SampleGridOverDistance grid{0.0, spacing};
  const auto count = static_cast<std::size_t>(std::lround(2000.0 / spacing)) + 1;
  const SampledRail rail(samplesOf(count, grid, [&](double s) { return a * std::sin(k * s); }), grid);
  std::pair<double, double> errors{0.0, 0.0};
  for (int i = 0; i < 40000; ++i) {
    const double s = 10.0 + 0.0494 * i;
    const RailPoint point = rail.at(s);
    errors.first = std::max(errors.first, std::abs(point.height - a * std::sin(k * s)));
    errors.second = std::max(errors.second, std::abs(point.slope - a * k * std::cos(k * s)));
  }
  return errors;
}

// The classical bounds of cubic splines, d^4 |z''''| / 384 and d^3 |z''''| / 24, are met to a few percent by a smooth wave
// (measured: 0.98 and 1.00 of them); half the spacing divides them by 16 and 8, up to the next order, (k d)^2 = 2 %.
TEST(SampledRail, FollowsAWaveToTheFourthOrderAndItsSlopeToTheThird) {
  const double k = 2.0 * std::acos(-1.0) / 10.0, a = 1e-3, d = 0.25;
  const auto [height, slope] = errorsAt(d);
  EXPECT_NEAR(height / (a * std::pow(k * d, 4) / 384.0), 1.0, 0.02);
  EXPECT_NEAR(slope / (a * k * std::pow(k * d, 3) * std::sqrt(3.0) / 216.0), 1.0, 0.02);
  const auto [finer_height, finer_slope] = errorsAt(0.5 * d);
  EXPECT_NEAR(height / finer_height, 16.0, 0.3);
  EXPECT_NEAR(slope / finer_slope, 8.0, 0.15);
}

std::shared_ptr<RailSamples> roughSamples(std::size_t count) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> height(-5e-3, 5e-3);
  std::vector<double> heights(count);
  for (double& each : heights) each = height(random);
  return std::make_shared<StoredSamples>(std::move(heights));
}

// Random heights, the worst that a spline can meet. On both sides of a sample: what a step of 1e-12 spacings changes (the
// slope of 0.1, the curvature of 2 /m, the third derivative of 50 /m^2 times 1e-13 m) and rounding; at the borders of
// blocks too, whose slopes are found from other samples on either side.
TEST(SampledRail, HeightSlopeAndCurvatureAreContinuousAtEverySample) {
  const double d = 0.25;
  const SampledRail rail(roughSamples(3 * SampledRail::kBlock), {0.0, d});
  for (std::int64_t k = 1; k + 1 < 3 * SampledRail::kBlock; ++k) {
    const double s = static_cast<double>(k) * d;
    const RailPoint left = rail.at(s * (1.0 - 4e-16)), right = rail.at(s);
    EXPECT_WITHIN(left.height, right.height, 1e-13);
    EXPECT_WITHIN(left.slope, right.slope, 1e-12);
    EXPECT_WITHIN(left.curvature, right.curvature, 3e-11);
  }
}

// More blocks than are kept: forwards by four wheels, then anywhere, on another object backwards. To the last bit.
TEST(SampledRail, NoValueDependsOnWhoReadsFirst) {
  const double d = 0.25;
  const std::size_t count = (SampledRail::kSlots + 6) * SampledRail::kBlock;
  const auto samples = roughSamples(count);
  const SampledRail ours(samples, {0.0, d}), other(samples, {0.0, d});
  std::vector<double> places;
  for (double s = 20.0; s < other.end(); s += 37.123) {
    for (const double behind : {0.0, 2.5, 17.0, 19.5}) places.push_back(s - behind);
  }
  std::vector<double> forwards;
  for (const double s : places) forwards.push_back(ours.at(s).slope);
  for (std::size_t i = places.size(); i-- > 0;) ASSERT_EQ(other.at(places[i]).slope, forwards[i]);
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i) {
    const std::size_t any = random() % places.size();
    ASSERT_EQ(ours.at(places[any]).slope, forwards[any]);
  }
}

// Four wheels over half a million samples: each block is asked for once, with no more around it than the spline needs.
TEST(SampledRail, AsksForItsSamplesAFewThousandAtATimeAndOnce) {
  const std::size_t count = 500 * SampledRail::kBlock + 1;
  const auto counted = std::make_shared<CountedSamples>(roughSamples(count));
  const SampledRail rail(counted, {0.0, 0.25});
  EXPECT_EQ(counted->requests, 0);
  for (double s = 0.0; s < rail.end(); s += 3.3) {
    for (const double behind : {0.0, 2.5, 17.0, 19.5}) (void)rail.at(std::max(0.0, s - behind));
  }
  EXPECT_EQ(counted->requests, 500);
  EXPECT_LE(counted->longest, static_cast<std::size_t>(SampledRail::kBlock + 2 * SampledRail::kReach + 1));
}

// Two samples are a line, three a parabola, four a cubic.
TEST(SampledRail, FewSamplesAreTheirPolynomial) {
  for (std::size_t count = 2; count <= 5; ++count) {
    const auto polynomial = [&](double s) {
      return std::pow(s - 0.3, static_cast<double>(std::min<std::size_t>(count, 4) - 1));
    };
    const SampledRail rail(samplesOf(count, {0.0, 0.5}, polynomial), {0.0, 0.5});
    EXPECT_WITHIN(rail.at(0.2).height, polynomial(0.2), 1e-15) << count;
    // Beyond its ends the last formula goes on.
    EXPECT_WITHIN(rail.at(-0.1).height, polynomial(-0.1), 1e-15) << count;
  }
}

TEST(SampledRail, RefusesWhatIsNoRail) {
  const auto one = std::make_shared<StoredSamples>(std::vector<double>{1.0});
  EXPECT_EQ(refusalOf([&] { SampledRail rail(one, {0.0, 1.0}); }), "sampled rail: 1 samples, must be 2 or more");
  const auto two = std::make_shared<StoredSamples>(std::vector<double>{1.0, 2.0});
  EXPECT_EQ(refusalOf([&] {
              SampledRail rail(two, {0.0, 0.0});
            }),
            "sampled rail: begin = 0 m, spacing = 0 m; must be finite, spacing > 0");
  std::vector<double> heights(3000, 1e-3);
  heights[2500] = std::numeric_limits<double>::quiet_NaN();
  const SampledRail hole(std::make_shared<StoredSamples>(heights), {10.0, 0.5});
  EXPECT_EQ(hole.at(600.0).height, 1e-3);
  try {
    (void)hole.at(1250.0);
    FAIL() << "a height that is no number was read";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "sampled rail: the height at s = 1260 m is nan, must be finite");
  }
}

TEST(RailPieces, OfSamplesAreLevelBeforeAndBehindThem) {
  const auto rail = std::make_shared<const SampledRail>(roughSamples(100), SampleGridOverDistance{5.0, 0.25});
  const std::vector<RailPiece> pieces = piecesOf(rail);
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces[0].to, 5.0);
  EXPECT_EQ(pieces[0].level, rail->at(5.0).height);
  EXPECT_EQ(pieces[1].to, 5.0 + 99 * 0.25);
  EXPECT_EQ(pieces[2].level, rail->at(pieces[1].to).height);
  EXPECT_TRUE(pieces[2].isStep());
  EXPECT_FALSE(pieces[1].isStep());
}

}  // namespace
}  // namespace vehicle
