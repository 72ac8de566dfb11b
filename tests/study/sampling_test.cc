#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <boost/random/sobol.hpp>

#include "libvehicle/study/plan/counted_random.h"
#include "libvehicle/study/plan/keyed_permutation.h"
#include "libvehicle/study/plan/latin_hypercube.h"
#include "libvehicle/study/plan/sobol_sequence.h"
#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

TEST(KeyedPermutation, ReachesEveryNumberOnceForEverySize) {
  for (std::uint64_t size = 1; size <= 300; ++size) {
    const KeyedPermutation permutation(size, 7);
    std::set<std::uint64_t> met;
    for (std::uint64_t i = 0; i < size; ++i) {
      ASSERT_LT(permutation.at(i), size);
      met.insert(permutation.at(i));
    }
    EXPECT_EQ(met.size(), size);
  }
  EXPECT_LT(KeyedPermutation(std::uint64_t{1} << 62, 1).at(12345), std::uint64_t{1} << 62);
  EXPECT_THROW(KeyedPermutation(0, 1), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(KeyedPermutation(5, 1).at(5)), std::invalid_argument);
}

// Each of the 16 x 16 (from, to) cells expects 1/16 of 4000 keys, 250 +- 15.3; the largest of 256 deviations stays
// within 5 of those (probability 1.5e-4 that one is outside), and the keys are fixed.
TEST(KeyedPermutation, AllPlacesAreEquallyLikelyOverTheKeys) {
  constexpr std::uint64_t kSize = 16;
  std::vector<int> met(kSize * kSize, 0);
  for (std::uint64_t key = 0; key < 4000; ++key) {
    const KeyedPermutation permutation(kSize, key);
    for (std::uint64_t i = 0; i < kSize; ++i) ++met[i * kSize + permutation.at(i)];
  }
  const auto [least, most] = std::minmax_element(met.begin(), met.end());
  EXPECT_GT(*least, 250 - 77);
  EXPECT_LT(*most, 250 + 77);
}

TEST(LatinHypercube, EveryStratumOfEveryDimensionHoldsExactlyOnePoint) {
  for (const std::uint64_t size : {1u, 2u, 7u, 100u, 1000u}) {
    const LatinHypercube plan(size, 5, 3);
    std::vector<std::set<std::uint64_t>> strata(5);
    std::vector<double> point(5);
    for (std::uint64_t i = 0; i < size; ++i) {
      plan.point(i, point);
      for (std::size_t d = 0; d < 5; ++d) {
        ASSERT_GE(point[d], 0.0);
        ASSERT_LT(point[d], 1.0);
        strata[d].insert(static_cast<std::uint64_t>(point[d] * static_cast<double>(size)));
      }
    }
    for (const auto& each : strata) EXPECT_EQ(each.size(), size);
  }
}

TEST(LatinHypercube, DimensionsAreIndependentAndSeedsDiffer) {
  constexpr std::uint64_t kSize = 10'000;
  const LatinHypercube plan(kSize, 4, 11);
  const LatinHypercube other(kSize, 4, 12);
  std::vector<double> sums(16, 0.0);
  double across = 0.0;
  std::vector<double> a(4);
  std::vector<double> b(4);
  for (std::uint64_t i = 0; i < kSize; ++i) {
    plan.point(i, a);
    other.point(i, b);
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) sums[j * 4 + k] += 12.0 * (a[j] - 0.5) * (a[k] - 0.5) / kSize;
    }
    across += 12.0 * (a[0] - 0.5) * (b[0] - 0.5) / kSize;
  }
  // A correlation of 10 000 independent pairs scatters by 0.01; that of a dimension with itself is 1.
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t k = 0; k < 4; ++k) EXPECT_WITHIN(sums[j * 4 + k], j == k ? 1.0 : 0.0, j == k ? 1e-4 : 0.04);
  }
  EXPECT_WITHIN(across, 0.0, 0.04);
}

// The mean of x^2 over n strata errs by about n^-1.5, where random points err by 0.3 n^-0.5: 3e-7 against 3e-3.
TEST(LatinHypercube, IntegratesOneDimensionFarBetterThanRandomPoints) {
  constexpr std::uint64_t kSize = 10'000;
  const LatinHypercube plan(kSize, 1, 5);
  double sum = 0.0;
  double x = 0.0;
  for (std::uint64_t i = 0; i < kSize; ++i) {
    plan.point(i, {&x, 1});
    sum += x * x / kSize;
  }
  EXPECT_WITHIN(sum, 1.0 / 3.0, 3e-6);
}

TEST(SobolSequence, IsThatOfBoostWithThePointAtZeroInFront) {
  constexpr std::size_t kDimensions = 50;
  const SobolSequence sequence(kDimensions, 0);
  boost::random::sobol boost_engine(kDimensions);
  std::vector<double> point(kDimensions);
  sequence.point(0, point);
  EXPECT_EQ(point, std::vector<double>(kDimensions, 0.0));
  for (std::uint64_t i = 1; i < 5000; ++i) {
    sequence.point(i, point);
    for (std::size_t d = 0; d < kDimensions; ++d) ASSERT_EQ(point[d], unitInterval(boost_engine())) << i << ' ' << d;
  }
  boost::random::sobol far(kDimensions);
  far.seed(987'654'321 - 1);
  sequence.point(987'654'321, point);
  for (std::size_t d = 0; d < kDimensions; ++d) EXPECT_EQ(point[d], unitInterval(far()));
}

// 2^m points of a (t, m, d) net: each dimension has one point in each of 2^m strata, shifted or not.
TEST(SobolSequence, TheFirstPowersOfTwoAreStratifiedWithEverySeed) {
  for (const std::uint64_t seed : {0u, 1u, 2u}) {
    const SobolSequence sequence(8, seed);
    std::vector<std::set<int>> strata(8);
    std::vector<double> point(8);
    for (std::uint64_t i = 0; i < 1024; ++i) {
      sequence.point(i, point);
      for (std::size_t d = 0; d < 8; ++d) strata[d].insert(static_cast<int>(point[d] * 1024.0));
    }
    for (const auto& each : strata) EXPECT_EQ(each.size(), 1024u);
  }
  EXPECT_THROW(SobolSequence(0, 1), std::invalid_argument);
  EXPECT_THROW(SobolSequence(SobolSequence::kMostDimensions + 1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace vehicle
