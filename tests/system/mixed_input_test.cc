#include "libvehicle/system/mixed_input.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/paper_matrices.h"
#include "tests/support/tolerance.h"

namespace vehicle::test {
namespace {

// Two channels on two segments: a harmonic and a cubic each.
Input twoChannels() {
  InputSegment first;
  first.begin = 0.0;
  first.end = 1.5;
  first.angular_frequency = {4.0, 9.0};
  first.cosine = {3e-3, 0.0, -1e-3, 2e-3};
  first.sine = {0.0, 1e-3, 5e-4, -2e-3};
  first.polynomial = {1e-3, -2e-3, 4e-4, 1e-4, 0.0, 3e-3, 0.0, -5e-4};
  InputSegment second;
  second.begin = 1.5;
  second.end = 2.0;
  second.polynomial = {2e-3, 0.0, 0.0, 0.0, 0.0, 1e-3, 0.0, 0.0};
  return Input(2, {first, second});
}

// Sum and difference of two channels against the two channels' own values: a dozen products and sums of 5e-3, each
// rounded at 1e-16 of it; a wrong weight is a difference of 1e-4 and more.
TEST(MixedInput, IsTheLinearCombinationOfTheChannelsValues) {
  const Input input = twoChannels();
  const Input mixed = mixedInput(input, std::vector<double>{0.5, 0.5, 1.0, -2.0, 0.0, 1.0});
  ASSERT_EQ(mixed.channels(), 3);
  ASSERT_EQ(mixed.segments(), 2);
  std::vector<double> u(6), v(9);
  for (int segment = 0; segment < 2; ++segment) {
    for (double t = input.segment(segment).begin; t <= input.segment(segment).end; t += 0.0625) {
      input.evaluate(segment, t, u);
      mixed.evaluate(segment, t, v);
      for (std::size_t kind = 0; kind < 3; ++kind) {  // height, rate, acceleration: up to 0.3 m/s^2
        EXPECT_WITHIN(v[3 * kind], 0.5 * (u[2 * kind] + u[2 * kind + 1]), 1e-15);
        EXPECT_WITHIN(v[3 * kind + 1], u[2 * kind] - 2.0 * u[2 * kind + 1], 1e-15);
        EXPECT_EQ(v[3 * kind + 2], u[2 * kind + 1]) << "a weight of 1 alone changes no bit";
      }
    }
  }
}

// Two wheels half a wavelength apart: their mean is a level rail, their half difference the sine itself.
TEST(MixedInput, TwoWheelsHalfAWavelengthApartCancelInTheirMean) {
  InputSegment segment;
  segment.end = 3.0;
  segment.angular_frequency = {2.0};
  segment.cosine = {0.0, 0.0};
  segment.sine = {5e-3, -5e-3};
  segment.polynomial.assign(8, 0.0);
  const Input mixed = mixedInput(Input(2, {segment}), std::vector<double>{0.5, 0.5, 0.5, -0.5});
  std::vector<double> u(4);
  for (double t = 0.0; t <= 3.0; t += 0.125) {
    mixed.evaluate(0, t, u);
    EXPECT_EQ(u[0], 0.0);
    EXPECT_EQ(u[2], 0.0);
    EXPECT_WITHIN(u[1], 5e-3 * std::sin(2.0 * t), 1e-18);  // one rounding of a product of 5e-3
    EXPECT_WITHIN(u[3], 1e-2 * std::cos(2.0 * t), 2e-18);
  }
}

// A channel that is swept alone and one that is swept among others: sums run in the same order.
TEST(MixedInput, AChannelHasTheSameBitsAloneAndAmongOthers) {
  const Input input = paperOnset(1.0);
  const std::vector<double> weights = {0.25, 0.25, 0.25, 0.25, 0.25, 0.25, -0.25, -0.25};
  const Input both = mixedInput(input, weights);
  constexpr int kCount = 301;
  std::vector<double> pair(4 * kCount), alone(2 * kCount);
  for (int segment = 0; segment < input.segments(); ++segment) {
    both.sweep(segment, input.segment(segment).begin, 5e-4, kCount, pair);
    for (std::size_t channel = 0; channel < 2; ++channel) {
      const Input one = mixedInput(input, std::span<const double>(weights).subspan(4 * channel, 4));
      one.sweep(segment, input.segment(segment).begin, 5e-4, kCount, alone);
      for (std::size_t i = 0; i < kCount; ++i) {
        EXPECT_EQ(alone[2 * i], pair[4 * i + channel]);
        EXPECT_EQ(alone[2 * i + 1], pair[4 * i + 2 + channel]);
      }
    }
  }
}

TEST(MixedInput, RefusesWeightsThatAreNoWholeRowsOrNotFinite) {
  const Input input = twoChannels();
  const auto refusal = [&](std::vector<double> weights) -> std::string {
    try {
      (void)mixedInput(input, weights);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "not refused";
  };
  EXPECT_EQ(refusal({}), "mixedInput: 0 weights, must be whole rows of 2, one a channel of the input");
  EXPECT_EQ(refusal({1.0, 0.0, 1.0}), "mixedInput: 3 weights, must be whole rows of 2, one a channel of the input");
  EXPECT_EQ(refusal({1.0, std::numeric_limits<double>::quiet_NaN()}),
            "mixedInput: weights[1] = nan, must be finite");
}

}  // namespace
}  // namespace vehicle::test
