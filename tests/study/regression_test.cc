#include "libvehicle/study/compare/regression.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

// x_i = sin and cos over whole periods are uncorrelated, each of variance 1/2; the large means would eat the digits of
// sums of squares (1e9^2 against 1/2: nothing would be left).
TEST(Regression, OfStraightLinesHasTheirCoefficientsFarFromZeroToo) {
  Regression regression(2);
  constexpr int kDesigns = 360;
  for (int i = 0; i < kDesigns; ++i) {
    const double angle = 2.0 * M_PI * i / kDesigns;
    const double x[] = {1e6 + std::sin(angle), -1e6 + std::cos(angle)};
    regression.add(x, 5.0 + 3.0 * (x[0] - 1e6) - 4.0 * (x[1] + 1e6));
  }
  const auto fit = regression.fit().value();
  // Rounding of numbers of 1e6 to 1e-10, against deviations of 1.
  EXPECT_WITHIN(fit.coefficients[0], 0.6, 1e-9);
  EXPECT_WITHIN(fit.coefficients[1], -0.8, 1e-9);
  EXPECT_WITHIN(fit.explained, 1.0, 1e-9);
  EXPECT_WITHIN(regression.correlations()[0], 0.6, 1e-9);
}

// y = x1 + e with x2 = x1 + e': x2 is correlated with y by itself, and has no coefficient beside x1.
TEST(Regression, TellsAFactorThatOnlyGoesAlongFromOneThatActs) {
  Regression regression(2);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 20'000; ++i) {
    const double acts = normal(random);
    const double x[] = {acts, acts + normal(random)};
    regression.add(x, acts + normal(random));
  }
  // Sampling error 1/sqrt(20 000) = 0.007.
  EXPECT_WITHIN(regression.correlations()[1], 0.5, 0.03);
  const auto fit = regression.fit().value();
  EXPECT_WITHIN(fit.coefficients[0], std::sqrt(0.5), 0.03);
  EXPECT_WITHIN(fit.coefficients[1], 0.0, 0.03);
  EXPECT_WITHIN(fit.explained, 0.5, 0.03);
}

TEST(Regression, WithoutEnoughToTellThereIsNoFit) {
  Regression regression(2);
  EXPECT_FALSE(regression.fit().has_value());
  for (int i = 0; i < 10; ++i) {
    const double together[] = {static_cast<double>(i), 2.0 * i};
    regression.add(together, i);
  }
  EXPECT_FALSE(regression.fit().has_value());
  const double broken[] = {NAN, 1.0};
  regression.add(broken, 1.0);
  EXPECT_EQ(regression.designs(), 10u);
  EXPECT_WITHIN(regression.correlations()[1], 1.0, 1e-12);  // rounding
}

// A wheel load of 161.9 kN that depends on nothing but comes out of sums: its last bits are no variation.
TEST(Regression, WhatRoundingLeavesOfAConstantIsNotExplained) {
  Regression regression(1);
  for (int i = 0; i < 100; ++i) {
    const double x[] = {1.0 + i};
    regression.add(x, 161865.0 + (i % 7 == 0 ? 2.9e-11 : 0.0));
  }
  EXPECT_FALSE(regression.fit().has_value());
  EXPECT_EQ(regression.correlations(), std::vector<double>{0.0});
}

}  // namespace
}  // namespace vehicle
