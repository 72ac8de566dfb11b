#include "libvehicle/system/sample_weights.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace vehicle {
namespace {

std::vector<double> nodesOf(std::size_t intervals, double first, double point_step, double last) {
  std::vector<double> nodes{0.0};
  for (std::size_t i = 0; i < intervals; ++i) {
    nodes.push_back(nodes.back() + (i == 0 ? first : i + 1 == intervals ? last : point_step));
  }
  return nodes;
}

// With two samples a straight line is what can be known; with three a parabola; from four on a cubic.
TEST(SampleWeights, IntegrateCubicsExactlyWhateverTheEnds) {
  for (std::size_t n = 1; n <= 40; ++n) {
    for (const double first : {1.0, 0.3, 0.02}) {
      for (const double last : {1.0, 0.7, 0.01}) {
        const SampleWeights weights(n, first, 1.0, n == 1 ? first : last);
        const std::vector<double> nodes = nodesOf(n, first, 1.0, n == 1 ? first : last);
        for (int power = 0; power <= std::min<int>(3, static_cast<int>(n)); ++power) {
          double sum = 0.0;
          for (std::size_t i = 0; i <= n; ++i) sum += weights[i] * std::pow(nodes[i], power);
          const double exact = std::pow(nodes.back(), power + 1) / (power + 1);
          // Weights of a short end interval are differences of numbers 1/0.01 apart.
          EXPECT_NEAR(sum, exact, 1e-11 * exact) << n << " intervals of 1 between " << first << " and " << last;
        }
      }
    }
  }
}

// Order 4: halving the spacing divides the error by 16. The worst of several lengths: at one alone the errors of both
// ends may cancel.
TEST(SampleWeights, ErrorOfASineFallsWithTheFourthPower) {
  const auto worst = [](std::size_t n) {
    double largest = 0.0;
    for (const double length : {5.0, 5.2, 5.4, 5.6, 5.8}) {
      const double step = length / static_cast<double>(n);
      const SampleWeights weights(n, step, step, step);
      double sum = 0.0;
      for (std::size_t i = 0; i <= n; ++i) sum += weights[i] * std::sin(3.0 * static_cast<double>(i) * step);
      largest = std::max(largest, std::abs(sum - (1.0 - std::cos(3.0 * length)) / 3.0));
    }
    return largest;
  };
  const double ratio = worst(400) / worst(800);
  EXPECT_GT(ratio, 15.0);  // the next term changes the ratio by some percent at 0.02 rad a sample
  EXPECT_LT(ratio, 34.0);  // where the leading terms of both ends cancel, order 5 shows
}

TEST(SampleWeights, ManySamplesWeighTheSpacingInside) {
  const SampleWeights weights(1000, 0.2, 0.5, 0.4);
  for (std::size_t i = 6; i < 994; ++i) ASSERT_EQ(weights[i], 0.5);
  double sum = 0.0;
  for (std::size_t i = 0; i <= 1000; ++i) sum += weights[i];
  EXPECT_NEAR(sum, 0.2 + 998 * 0.5 + 0.4, 1e-10);
}

}  // namespace
}  // namespace vehicle
