#include "libvehicle/partition/map/equation_map.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "libvehicle/partition/map/equation_graph.h"
#include "tests/support/mass_graph.h"

namespace vehicle::test {
namespace {

using Shares = std::vector<std::vector<int>>;

std::string refusal(const EquationSet& set, EquationMap map, int threads, std::vector<double> cost = {}) {
  try {
    (void)shareEquations(set, map, threads, cost);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing";
}

/// Equations with names and reads alone.
class NamedSet : public EquationSet {
 public:
  explicit NamedSet(std::vector<Equation> equations) : equations_(std::move(equations)) {}
  int channels() const override { return 4; }
  const std::vector<Equation>& equations() const override { return equations_; }
  const std::vector<int>& stateOrder() const override { return order_; }
  const std::vector<int>& channelOrder() const override { return order_; }
  void derivative(const EquationWindow&) const override {}

 private:
  std::vector<Equation> equations_;
  std::vector<int> order_;
};

NamedSet vehicleSet() {
  return NamedSet({{"carbody bounce (2)", {1, 2, 3}},
                   {"carbody pitch (3)", {0, 2, 3}},
                   {"front_bogie bounce (4)", {0, 1}, 0, 2},
                   {"rear_bogie bounce (5)", {0, 1}, 2, 4}});
}

void expectEachEquationOnce(const Shares& shares, int equations) {
  std::vector<int> all;
  for (const std::vector<int>& share : shares) {
    EXPECT_FALSE(share.empty());
    EXPECT_TRUE(std::is_sorted(share.begin(), share.end()));
    all.insert(all.end(), share.begin(), share.end());
  }
  std::sort(all.begin(), all.end());
  std::vector<int> expected(static_cast<std::size_t>(equations));
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(all, expected);
}

double heaviest(const Shares& shares, const std::vector<double>& cost) {
  double most = 0.0;
  for (const std::vector<int>& share : shares) {
    double load = 0.0;
    for (const int e : share) load += cost[static_cast<std::size_t>(e)];
    most = std::max(most, load);
  }
  return most;
}

// Closed form by exhaustion: every way to cut so few items into runs.
double lightestPossible(const std::vector<double>& cost, std::size_t first, int parts) {
  double rest = 0.0;
  for (std::size_t i = first; i < cost.size(); ++i) rest += cost[i];
  if (parts == 1) return rest;
  double best = rest, run = 0.0;
  for (std::size_t end = first + 1; end + static_cast<std::size_t>(parts) - 1 <= cost.size(); ++end) {
    run += cost[end - 1];
    best = std::min(best, std::max(run, lightestPossible(cost, end, parts - 1)));
  }
  return best;
}

TEST(EquationMap, PaperIsThePrintedDistribution) {
  EXPECT_EQ(shareEquations(vehicleSet(), EquationMap::kPaper, 4), (Shares{{3}, {0}, {1}, {2}}));
}

TEST(EquationMap, PaperRefusesAnythingElseWithTheReason) {
  EXPECT_EQ(
      refusal(vehicleSet(), EquationMap::kPaper, 2),
      "map paper divides the four equations of the source paper's vehicle among four threads; here are 2 threads; take "
      "4, or map auto or body");
  EXPECT_EQ(
      refusal(massChain(8).set(), EquationMap::kPaper, 4),
      "map paper divides the four equations of the source paper's vehicle among four threads; here are 8 equations; "
      "take map auto or body");
  EXPECT_EQ(
      refusal(massVehicle().set(), EquationMap::kPaper, 4),
      "map paper divides the four equations of the source paper's vehicle among four threads; here no equation is "
      "named (5); take map auto or body");
}

TEST(EquationMap, BodyTellsTheMostThreadsThatItCanTakeWhateverIsAsked) {
  for (const int threads : {4, 5, 100}) {
    EXPECT_EQ(refusal(vehicleSet(), EquationMap::kBody, threads),
              std::to_string(threads) +
                  " threads for 3 bodies: map body gives every thread at least one; take at most 3");
  }
}

TEST(EquationMap, BodyKeepsTheEquationsOfABodyTogether) {
  EXPECT_EQ(shareEquations(vehicleSet(), EquationMap::kBody, 3), (Shares{{0, 1}, {2}, {3}}));
  EXPECT_EQ(shareEquations(vehicleSet(), EquationMap::kBody, 1), (Shares{{0, 1, 2, 3}}));
  // Names as a form of any topology gives them, of the second vehicle of a train.
  const NamedSet train({{"coach_2.carbody.z", {1, 2}}, {"coach_2.carbody.pitch", {0, 2}}, {"coach_2.bogie.z", {0, 1}}});
  EXPECT_EQ(shareEquations(train, EquationMap::kBody, 2), (Shares{{0, 1}, {2}}));
  EXPECT_EQ(refusal(train, EquationMap::kBody, 3),
            "3 threads for 2 bodies: map body gives every thread at least one; take at most 2");
  const MassGraph chain = massChain(16);  // eight bodies of two masses
  for (int threads = 1; threads <= 8; ++threads) {
    const Shares shares = shareEquations(chain.set(), EquationMap::kBody, threads);
    expectEachEquationOnce(shares, 16);
    for (const std::vector<int>& share : shares) {
      EXPECT_EQ(share.front() % 2, 0);
      EXPECT_EQ(share.size() % 2, 0u);
      EXPECT_EQ(share.back() - share.front() + 1, static_cast<int>(share.size()));
    }
  }
}

TEST(EquationMap, MoreThreadsThanThereIsWorkForAreRefused) {
  EXPECT_EQ(refusal(vehicleSet(), EquationMap::kAuto, 7),
            "7 threads for 4 equations: map auto gives every thread at least one; take at most 4");
  EXPECT_EQ(refusal(vehicleSet(), EquationMap::kBody, 4),
            "4 threads for 3 bodies: map body gives every thread at least one; take at most 3");
  EXPECT_EQ(refusal(vehicleSet(), EquationMap::kAuto, 0), "equation map: threads = 0, must be >= 1");
}

TEST(EquationMap, CostsThatDoNotFitAreRefused) {
  EXPECT_EQ(refusal(vehicleSet(), EquationMap::kAuto, 2, {1.0}),
            "equation map: 1 costs, must be 4, one an equation");
  EXPECT_EQ(refusal(vehicleSet(), EquationMap::kAuto, 2, {1.0, -1.0, 1.0, 1.0}),
            "equation map: cost[1] = -1.000000, must be finite and > 0");
}

TEST(EquationMap, AutoGivesEveryThreadCountEveryEquationOnce) {
  for (const MassGraph& graph : {massChain(23, 2), massChain(64), massRing(12), massVehicle()}) {
    const int equations = static_cast<int>(graph.set().equations().size());
    for (int threads = 1; threads <= std::min(equations, 23); ++threads) {
      expectEachEquationOnce(shareEquations(graph.set(), EquationMap::kAuto, threads), equations);
    }
  }
}

// The cut may cost 3 % over the lightest possible, where that lets fewer values cross it.
TEST(EquationMap, AutoCutsAChainIntoRunsNearTheLightestPossible) {
  const MassGraph chain = massChain(20);
  std::vector<double> cost;
  for (int e = 0; e < 20; ++e) cost.push_back(1.0 + 0.8 * std::sin(1.7 * e));
  for (int threads = 1; threads <= 8; ++threads) {
    const Shares shares = shareEquations(chain.set(), EquationMap::kAuto, threads, cost);
    for (const std::vector<int>& share : shares) {
      EXPECT_EQ(share.back() - share.front() + 1, static_cast<int>(share.size()));
    }
    const double total = std::accumulate(cost.begin(), cost.end(), 0.0);
    EXPECT_LE(heaviest(shares, cost),
              std::max(lightestPossible(cost, 0, threads), 1.03 * total / threads) * (1.0 + 1e-6))
        << threads << " threads";
  }
}

// Two clusters of four that one link joins, their equations interleaved: an order tells nothing.
TEST(EquationMap, AutoFindsTheClustersOfAGraph) {
  std::vector<MassLink> links;
  for (int one = 0; one < 8; ++one) {
    for (int other = one + 2; other < 8; other += 2) links.push_back({one, other, 50.0, 1.0});
  }
  links.push_back({0, 1, 10.0, 1.0});
  const MassGraph graph(8, links, std::vector<bool>(8, false));
  EXPECT_EQ(shareEquations(graph.set(), EquationMap::kAuto, 2), (Shares{{0, 2, 4, 6}, {1, 3, 5, 7}}));
}

// Bogies read the rail and cost more: one of them on each side.
TEST(EquationMap, AutoBalancesTheRailOfOneVehicle) {
  const Shares shares = shareEquations(vehicleSet(), EquationMap::kAuto, 2);
  EXPECT_EQ(heaviest(shares, {1.0, 1.0, 2.0, 2.0}), 3.0);
}

TEST(EquationGraph, ReachIsTheHullOfNeighbours) {
  const MassGraph chain = massChain(20, 2);
  const EquationGraph graph(chain.set());
  EXPECT_EQ(graph.reach({8, 10}), (EquationRun{6, 12}));
  EXPECT_EQ(graph.reach({0, 1}), (EquationRun{0, 3}));
  EXPECT_EQ(graph.channels({2, 5}).first, 1);  // masses 0, 2, 4 have the channels 0, 1, 2
  EXPECT_EQ(graph.channels({2, 5}).last, 3);
  EXPECT_EQ(graph.channels({1, 2}).size(), 0);
}

TEST(EquationGraph, ReadsThatDoNotExistAreNamed) {
  const NamedSet set({{"one", {3}}});
  try {
    const EquationGraph graph(set);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "equation \"one\" reads equation 3, must be 0 to 0");
  }
}

}  // namespace
}  // namespace vehicle::test
