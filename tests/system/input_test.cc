#include "libvehicle/system/input.h"

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

// The paper's rail: 5 mm sin(w t) + 2 mm sin(3 w t) under `channels` wheels, 0.1 s after one another.
constexpr double kOmega = 5.026548245743669;  // [rad/s] 20 m/s over 25 m

InputSegment rail(int channels, double begin, double end) {
  InputSegment piece;
  piece.begin = begin;
  piece.end = end;
  piece.angular_frequency = {kOmega, 3.0 * kOmega};
  for (int j = 0; j < channels; ++j) {
    const double local = begin - 0.1 * j;
    for (const auto& [order, amplitude] : {std::pair{1, 5e-3}, std::pair{3, 2e-3}}) {
      piece.cosine.push_back(amplitude * std::sin(order * kOmega * local));
      piece.sine.push_back(amplitude * std::cos(order * kOmega * local));
    }
    piece.polynomial.insert(piece.polynomial.end(), {1e-3 * j, 2e-3, -3e-4, 5e-5 * j});
  }
  return piece;
}

InputSegment flatRail(double begin, double end) {
  InputSegment piece;
  piece.begin = begin;
  piece.end = end;
  piece.polynomial.assign(4, 0.0);
  return piece;
}

std::string refusal(int channels, std::vector<InputSegment> segments) {
  try {
    const Input input(channels, std::move(segments));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Input, HeightsRatesAndAccelerationsAreThoseOfTheFormula) {
  for (const int channels : {1, 3, 4, 7}) {
    const Input input(channels, {rail(channels, 2.0, 9.0)});
    const auto w = static_cast<std::size_t>(channels);
    std::vector<double> u(3 * w);
    for (const double t : {2.0, 3.7, 9.0}) {
      input.evaluate(0, t, u);
      for (std::size_t j = 0; j < w; ++j) {
        const double n = static_cast<double>(j);
        const double s = t - 2.0;
        const double angle = kOmega * (t - 0.1 * n);
        const double height = 5e-3 * std::sin(angle) + 2e-3 * std::sin(3 * angle) + 1e-3 * n + 2e-3 * s -
                              3e-4 * s * s + 5e-5 * n * s * s * s;
        const double rate = kOmega * (5e-3 * std::cos(angle) + 6e-3 * std::cos(3 * angle)) + 2e-3 - 6e-4 * s +
                            15e-5 * n * s * s;
        const double acceleration =
            -kOmega * kOmega * (5e-3 * std::sin(angle) + 18e-3 * std::sin(3 * angle)) - 6e-4 + 30e-5 * n * s;
        // Rounding: of phases up to 136 rad (1.4e-14) times 5 mm, and times w or w^2 for rates, accelerations.
        EXPECT_WITHIN(u[j], height, 3e-16);
        EXPECT_WITHIN(u[w + j], rate, 2e-15);
        EXPECT_WITHIN(u[2 * w + j], acceleration, 2e-14);
      }
    }
  }
}

TEST(Input, AskedWithoutAccelerationsGivesTheSameBits) {
  const Input input(4, {rail(4, 0.0, 9.0)});
  std::vector<double> two(8), three(12);
  for (int i = 0; i <= 100; ++i) {
    input.evaluate(0, 0.09 * i, two);
    input.evaluate(0, 0.09 * i, three);
    three.resize(8);
    EXPECT_EQ(two, three) << "sample " << i;
    three.resize(12);
  }
}

// Richardson-extrapolated central difference, error h^4 f^(5) / 5! ~ 1e-9 of the value at h = 1e-3 and 15 rad/s.
TEST(Input, RatesAndAccelerationsAreDerivativesOfTheHeights) {
  const Input input(4, {rail(4, 0.0, 9.0)});
  std::vector<double> u(12), a(8), b(8), c(8), d(8);
  const double h = 1e-3;
  for (int i = 1; i < 50; ++i) {
    const double t = 0.17 * i;
    input.evaluate(0, t, u);
    input.evaluate(0, t - 2 * h, a);
    input.evaluate(0, t - h, b);
    input.evaluate(0, t + h, c);
    input.evaluate(0, t + 2 * h, d);
    for (std::size_t k = 0; k < 8; ++k) {
      const double difference = (8.0 * (c[k] - b[k]) - (d[k] - a[k])) / (12.0 * h);
      // Truncation h^4 w^5 a / 30: 5e-11 m/s for the rates, times w = 15 for the accelerations.
      EXPECT_WITHIN(u[4 + k], difference, k < 4 ? 1e-10 : 2e-9);
    }
  }
}

TEST(Input, AtABreakpointEachSegmentGivesItsOwnLimit) {
  InputSegment after = flatRail(1.0, 2.0);
  after.polynomial = {0.0, 0.3, 0.0, 0.0};
  const Input input(1, {flatRail(0.0, 1.0), after});
  std::vector<double> u(2);
  input.evaluate(0, 1.0, u);
  EXPECT_EQ(u, (std::vector<double>{0.0, 0.0}));
  input.evaluate(1, 1.0, u);
  EXPECT_EQ(u, (std::vector<double>{0.0, 0.3}));
  EXPECT_EQ(input.begin(), 0.0);
  EXPECT_EQ(input.end(), 2.0);
}

TEST(Input, SweepStaysWithinItsStatedErrorOfSingleValues) {
  for (const int channels : {2, 4}) {
    const Input input(channels, {rail(channels, 2.0, 400.0)});
    const auto w = static_cast<std::size_t>(channels);
    for (const double dt : {1e-5, 5e-4, 5e-3, 0.3}) {  // 0.3 s: more than half a turn a sample
      const int count = 1000;
      std::vector<double> swept(2 * w * count), u(2 * w);
      input.sweep(0, 3.1, dt, count, swept);
      const double largest = 3.1 + count * dt;
      const double slow = Input::sweepError(5e-3, kOmega, largest);
      const double fast = Input::sweepError(2e-3, 3 * kOmega, largest);
      double worst = 0.0;
      for (int i = 0; i < count; ++i) {
        input.evaluate(0, 3.1 + i * dt, u);
        for (std::size_t j = 0; j < w; ++j) {
          const std::size_t at = static_cast<std::size_t>(i) * 2 * w + j;
          // The polynomial is the same expression on both sides; adding it rounds by 1e-16 of its size.
          const double shared = 4e-16 * (std::abs(u[j]) + std::abs(u[w + j]));
          EXPECT_WITHIN(swept[at], u[j], slow + fast + shared);
          EXPECT_WITHIN(swept[at + w], u[w + j], kOmega * slow + 3 * kOmega * fast + shared);
          worst = std::max(worst, std::abs(swept[at] - u[j]) / (slow + fast + shared));
        }
      }
      // The bound would be idle if it stood decades above what happens.
      EXPECT_GT(worst, 1e-3) << "dt " << dt;
    }
  }
}

TEST(Input, SweepServesAnyNumberOfFrequenciesWithAndWithoutPolynomial) {
  for (const std::size_t frequencies : {0u, 1u, 2u, 3u, 5u, 8u}) {
    for (const double level : {0.0, 1.0}) {
      InputSegment piece;
      piece.begin = 0.0;
      piece.end = 10.0;
      for (std::size_t f = 0; f < frequencies; ++f) {
        piece.angular_frequency.push_back(1.0 + 0.7 * static_cast<double>(f));
        piece.cosine.push_back(0.1 * static_cast<double>(f + 1));
        piece.sine.push_back(0.2);
      }
      piece.polynomial = {level, -level, 2.0 * level, -0.5 * level};
      const Input input(1, {piece});
      std::vector<double> swept(2 * 150), u(2);
      input.sweep(0, 0.2, 1e-2, 150, swept);
      for (std::size_t i = 0; i < 150; ++i) {
        input.evaluate(0, 0.2 + static_cast<double>(i) * 1e-2, u);
        // sweepError of at most 5 m in all, at 10 s: 3e-13, of which rounding uses a few per cent.
        EXPECT_WITHIN(swept[2 * i], u[0], 2e-14);
        EXPECT_WITHIN(swept[2 * i + 1], u[1], 6e-14);
      }
    }
  }
}

TEST(Input, SweepCutAtBlocksGivesTheBitsOfOneSweep) {
  const Input input(4, {rail(4, 0.0, 9.0)});
  const int count = 5 * Input::kBlock + 17;
  std::vector<double> whole(static_cast<std::size_t>(count) * 8), cut(whole.size());
  input.sweep(0, 0.7, 1e-3, count, whole);
  for (int first = 0; first < count; first += 2 * Input::kBlock) {
    const int some = std::min(2 * Input::kBlock, count - first);
    const std::span<double> part(cut.data() + first * 8, static_cast<std::size_t>(some) * 8);
    input.sweep(0, 0.7, 1e-3, first, some, part);
  }
  EXPECT_EQ(whole, cut);
  EXPECT_THROW(input.sweep(0, 0.7, 1e-3, 5, 1, std::span<double>(cut.data(), 8)), std::invalid_argument);
  EXPECT_THROW(input.sweep(0, 0.7, 1e-3, 0, 2, std::span<double>(cut.data(), 8)), std::invalid_argument);
}

TEST(Input, RefusesWhatBreaksARuleAndNamesTheSegment) {
  EXPECT_EQ(refusal(0, {flatRail(0, 1)}), "Input: channels = 0, must be >= 1");
  EXPECT_EQ(refusal(1, {}), "Input: no segments, must have at least one");
  EXPECT_EQ(refusal(1, {flatRail(0, 1), flatRail(1, 1)}),
            "Input: segment 1: lasts from 1 s to 1 s, must be finite and end after it begins");
  EXPECT_EQ(refusal(1, {flatRail(0, 1), flatRail(2, 3)}),
            "Input: segment 1: begins at 2 s, must begin where the one before ends, at 1 s");
  EXPECT_EQ(refusal(2, {flatRail(0, 1)}), "Input: segment 0: polynomial has 4 values, must have 8");

  InputSegment piece = rail(1, 0, 1);
  piece.sine.pop_back();
  EXPECT_EQ(refusal(1, {piece}), "Input: segment 0: sine has 1 values, must have 2");
  piece = rail(1, 0, 1);
  piece.angular_frequency[1] = kOmega;
  EXPECT_EQ(refusal(1, {piece}), "Input: segment 0: angular_frequency 5.026548245743669 rad/s stands there twice");
  piece.angular_frequency[1] = -1.0;
  EXPECT_EQ(refusal(1, {piece}), "Input: segment 0: angular_frequency = -1 rad/s, must be > 0");
  piece = rail(1, 0, 1);
  piece.cosine[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(1, {piece}), "Input: segment 0: cosine[1] = nan, must be finite");
  piece = rail(1, 0, 1);
  piece.polynomial[2] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(1, {piece}), "Input: segment 0: polynomial[2] = inf, must be finite");
  EXPECT_EQ(refusal(1, {flatRail(0, std::numeric_limits<double>::infinity())}),
            "Input: segment 0: lasts from 0 s to inf s, must be finite and end after it begins");

  const Input input(2, {rail(2, 0, 1)});
  std::vector<double> u(3);
  EXPECT_THROW(input.evaluate(0, 0.5, u), std::invalid_argument);
}

double storedError(int samples) {
  const double dt = 2.0 / (samples - 1);
  std::vector<double> height, rate;
  for (int i = 0; i < samples; ++i) {
    height.push_back(std::sin(kOmega * i * dt));
    rate.push_back(kOmega * std::cos(kOmega * i * dt));
  }
  const Input input = storedInput(1, 0.0, dt, height, rate);
  std::vector<double> u(2);
  double worst = 0.0;
  for (int i = 0; i < input.segments(); ++i) {
    for (const double share : {0.1, 0.3, 0.5, 0.8}) {
      const double t = input.segment(i).begin + share * dt;
      input.evaluate(i, t, u);
      worst = std::max(worst, std::abs(u[0] - std::sin(kOmega * t)));
    }
  }
  return worst;
}

// Order 4: the hold's error is dt^4 f'''' / 384; at w dt = 0.05 the next term is (w dt)^2 = 0.3 % of it and the
// places looked at do not move within a piece, so the ratio is 16 to a few per cent.
TEST(StoredInput, HalvingTheSamplingStepDividesTheErrorBySixteen) {
  const double coarse = storedError(201);
  const double ratio = coarse / storedError(401);
  EXPECT_GT(ratio, 15.5);
  EXPECT_LT(ratio, 16.5);
  EXPECT_WITHIN(coarse, std::pow(kOmega * 0.01, 4) / 384.0, 0.02 * coarse);  // the constant of the hold itself
}

TEST(StoredInput, IsExactForCubics) {
  const auto cubic = [](double t) { return 0.3 - 0.2 * t + 0.7 * t * t - 0.11 * t * t * t; };
  const auto slope = [](double t) { return -0.2 + 1.4 * t - 0.33 * t * t; };
  std::vector<double> height, rate;
  for (int i = 0; i < 21; ++i) {
    for (const double sign : {1.0, -2.0}) {
      height.push_back(sign * cubic(1.0 + 0.1 * i));
      rate.push_back(sign * slope(1.0 + 0.1 * i));
    }
  }
  const Input input = storedInput(2, 1.0, 0.1, height, rate);
  ASSERT_EQ(input.segments(), 20);
  std::vector<double> u(6);
  for (int i = 0; i < 20; ++i) {
    const double t = input.segment(i).begin + 0.037;
    input.evaluate(i, t, u);
    // Values of order 1, divided differences lose 1/dt a time: 1e-16, 1e-15, 1e-14 times ten.
    EXPECT_WITHIN(u[0], cubic(t), 4e-15);
    EXPECT_WITHIN(u[1], -2.0 * cubic(t), 4e-15);
    EXPECT_WITHIN(u[2], slope(t), 4e-14);
    EXPECT_WITHIN(u[3], -2.0 * slope(t), 4e-14);
    EXPECT_WITHIN(u[4], 1.4 - 0.66 * t, 1e-12);
  }
}

TEST(StoredInput, JoinsItsPiecesInHeightAndRate) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  std::vector<double> height(50), rate(50);
  for (double& h : height) h = value(random);
  for (double& r : rate) r = value(random);
  const Input input = storedInput(1, 0.3, 0.1, height, rate);
  std::vector<double> before(2), after(2);
  for (int i = 1; i < input.segments(); ++i) {
    input.evaluate(i - 1, input.segment(i).begin, before);
    input.evaluate(i, input.segment(i).begin, after);
    EXPECT_EQ(after[0], height[static_cast<std::size_t>(i)]);
    EXPECT_EQ(after[1], rate[static_cast<std::size_t>(i)]);
    EXPECT_WITHIN(before[0], after[0], 2e-15);  // rounding of a cubic with terms of order 1
    EXPECT_WITHIN(before[1], after[1], 2e-13);  // cancelling terms 2 c2 dt of order 100 m/s
  }
}

TEST(StoredInput, RefusesWrongShapesAndNumbersThatAreNone) {
  const std::vector<double> two{0.0, 1.0};
  const std::vector<double> three{0.0, 1.0, 2.0};
  EXPECT_THROW((void)storedInput(0, 0.0, 0.1, two, two), std::invalid_argument);
  EXPECT_THROW((void)storedInput(1, 0.0, 0.0, two, two), std::invalid_argument);
  EXPECT_THROW((void)storedInput(1, 0.0, 0.1, two, three), std::invalid_argument);
  EXPECT_THROW((void)storedInput(2, 0.0, 0.1, two, two), std::invalid_argument);
  try {
    (void)storedInput(1, 0.0, 0.1, std::vector<double>{0.0, std::nan("")}, two);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "storedInput: sample 1, channel 0: height = nan m, rate = 1 m/s, must be finite");
  }
}

}  // namespace
}  // namespace vehicle
