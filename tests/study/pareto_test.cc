#include "libvehicle/study/compare/pareto.h"

#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "tests/study/hypervolume.h"
#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

std::vector<double> randomTable(std::size_t designs, std::size_t objectives, int levels, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> level(0, levels);
  std::vector<double> values(designs * objectives);
  for (double& each : values) each = level(random);
  return values;
}

/// Whether nothing in the table dominates the row, by the definition.
bool isOnFront(std::span<const double> values, std::size_t objectives, std::size_t row) {
  for (std::size_t other = 0; other < values.size() / objectives; ++other) {
    if (dominates(values.subspan(other * objectives, objectives), values.subspan(row * objectives, objectives))) {
      return false;
    }
  }
  return true;
}

TEST(Dominates, NeedsOneBetterAndNoneWorse) {
  const auto judge = [](std::vector<double> a, std::vector<double> b) { return dominates(a, b); };
  EXPECT_TRUE(judge({1, 2}, {1, 3}));
  EXPECT_FALSE(judge({1, 2}, {1, 2}));
  EXPECT_FALSE(judge({1, 4}, {2, 3}));
}

// Few levels make many ties and equal designs, where sorting is easily wrong.
TEST(ParetoFront, GatheredOneByOneItIsWhatNothingDominates) {
  for (std::size_t objectives = 1; objectives <= 4; ++objectives) {
    for (unsigned seed = 0; seed < 20; ++seed) {
      const std::vector<double> values = randomTable(200, objectives, seed % 2 == 0 ? 6 : 1000, 100 + seed);
      ParetoFront front(objectives);
      std::set<std::vector<double>> expected;
      for (std::size_t i = 0; i < values.size() / objectives; ++i) {
        const auto own = std::span(values).subspan(i * objectives, objectives);
        if (isOnFront(values, objectives, i)) expected.insert({own.begin(), own.end()});
        front.add(i, own);
      }
      std::vector<std::vector<double>> gathered;
      for (const ParetoFront::Member& each : front.members()) {
        gathered.push_back(each.objectives);
        EXPECT_TRUE(isOnFront(values, objectives, each.design));
      }
      EXPECT_EQ(gathered, (std::vector<std::vector<double>>{expected.begin(), expected.end()}));
    }
  }
}

TEST(ParetoFront, OfEqualDesignsTheFirstStaysAndWhatIsNotFiniteIsLeftOut) {
  ParetoFront front(2);
  EXPECT_TRUE(front.add(7, std::vector<double>{1, 2}));
  EXPECT_FALSE(front.add(8, std::vector<double>{1, 2}));
  EXPECT_FALSE(front.add(9, std::vector<double>{NAN, 0}));
  ASSERT_EQ(front.members().size(), 1u);
  EXPECT_EQ(front.members()[0].design, 7u);
}

// f1 = x, f2 = g (1 - sqrt(x / g)): the front is g = 1, f2 = 1 - sqrt(f1). Source: Zitzler, Deb, Thiele,
// Evol. Comput. 8 (2000) 173 (ZDT1).
TEST(ParetoFront, OfZdt1IsItsKnownCurveWithItsKnownArea) {
  ParetoFront front(2);
  std::uint64_t design = 0;
  constexpr int kSteps = 1000;
  for (int i = 0; i <= kSteps; ++i) {
    for (const double g : {1.0, 1.5, 2.0}) {
      const double x = static_cast<double>(i) / kSteps;
      front.add(design++, std::vector<double>{x, g * (1.0 - std::sqrt(x / g))});
    }
  }
  ASSERT_EQ(front.members().size(), kSteps + 1u);
  std::vector<double> flat;
  for (const ParetoFront::Member& each : front.members()) {
    EXPECT_EQ(each.design % 3, 0u);
    flat.insert(flat.end(), each.objectives.begin(), each.objectives.end());
  }
  // Area up to (1, 1): integral of sqrt(x) = 2/3, less half a step of the staircase, 1/2000.
  EXPECT_WITHIN(hypervolume(flat, {1.0, 1.0}), 2.0 / 3.0 - 0.5 / kSteps, 1e-4);
}

TEST(Hypervolume, OfAStaircaseIsTheSumOfItsSteps) {
  const std::vector<double> staircase = {1, 3, 2, 2, 3, 1};
  EXPECT_EQ(hypervolume(staircase, {4.0, 4.0}), 3.0 + 2.0 + 1.0);
  const std::vector<double> with_more = {3, 1, 2.5, 2.5, 1, 3,
                                         2, 2, 5,   0,   0, 5};  // dominated, and beyond the reference
  EXPECT_EQ(hypervolume(with_more, {4.0, 4.0}), 6.0);
  EXPECT_EQ(hypervolume({}, {1.0, 1.0}), 0.0);
}

}  // namespace
}  // namespace vehicle
