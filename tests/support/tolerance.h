#pragma once

#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

namespace vehicle::test {

/// VEHICLE_TOLERANCE_SCALE=0 makes every tolerance zero: each check then fails and prints its real residual.
inline double toleranceScale() {
  static const double scale = [] {
    const char* text = std::getenv("VEHICLE_TOLERANCE_SCALE");
    return text != nullptr ? std::atof(text) : 1.0;
  }();
  return scale;
}

/// |actual - expected| <= tolerance, NaN fails; prints the residual and what it was allowed to be.
inline ::testing::AssertionResult within(double actual, double expected, double tolerance) {
  const double residual = std::abs(actual - expected);
  if (residual <= tolerance * toleranceScale()) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << actual << " differs from " << expected << " by " << residual << ", allowed "
                                       << tolerance * toleranceScale();
}

}  // namespace vehicle::test

#define EXPECT_WITHIN(actual, expected, tolerance) EXPECT_TRUE(::vehicle::test::within(actual, expected, tolerance))
#define ASSERT_WITHIN(actual, expected, tolerance) ASSERT_TRUE(::vehicle::test::within(actual, expected, tolerance))
