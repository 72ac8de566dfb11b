#include "libvehicle/integrate/tableau.h"

#include <string>
#include <vector>

#include "tests/support/tolerance.h"

// The tableaux are data; the order conditions of Butcher's rooted trees are the truth. One line a tree.
// Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed., table II.2.1.
namespace vehicle {
namespace {

using Stages = std::vector<double>;

struct Tree {
  std::string name;
  int order;
  double density;  // gamma: the condition is sum_i b_i Phi_i = 1 / gamma, for a continuous b_i(s): s^order / gamma
  Stages phi;      // Phi_i
};

template <int S>
std::vector<Tree> treesOf(const Tableau<S>& t) {
  const Stages c(t.c.begin(), t.c.end());
  const auto A = [&](const Stages& v) {
    Stages product(S, 0.0);
    for (std::size_t i = 0; i < S; ++i) {
      for (std::size_t j = 0; j < S; ++j) product[i] += t.a[i][j] * v[j];
    }
    return product;
  };
  const auto times = [](const Stages& v, const Stages& w) {
    Stages product(S);
    for (std::size_t i = 0; i < S; ++i) product[i] = v[i] * w[i];
    return product;
  };
  const Stages one(S, 1.0), c2 = times(c, c), c3 = times(c2, c), Ac = A(c);
  return {{"1", 1, 1, one},
          {"c", 2, 2, c},
          {"c2", 3, 3, c2},
          {"Ac", 3, 6, Ac},
          {"c3", 4, 4, c3},
          {"c Ac", 4, 8, times(c, Ac)},
          {"A c2", 4, 12, A(c2)},
          {"AA c", 4, 24, A(Ac)},
          {"c4", 5, 5, times(c3, c)},
          {"c2 Ac", 5, 10, times(c2, Ac)},
          {"c A c2", 5, 15, times(c, A(c2))},
          {"c AA c", 5, 30, times(c, A(Ac))},
          {"(Ac)2", 5, 20, times(Ac, Ac)},
          {"A c3", 5, 20, A(c3)},
          {"A(c Ac)", 5, 40, A(times(c, Ac))},
          {"AA c2", 5, 60, A(A(c2))},
          {"AAA c", 5, 120, A(A(Ac))}};
}

double weighted(const auto& b, const Stages& phi) {
  double sum = 0.0;
  for (std::size_t i = 0; i < phi.size(); ++i) sum += b[i] * phi[i];
  return sum;
}

// Entries of up to 30 add and cancel to order one: some 20 roundings of 30 x 1.1e-16. A wrong digit anywhere shows
// at 1e-6 or above.
constexpr double kRounding = 1e-13;

template <int S>
void expectRowsSumToNodes(const Tableau<S>& t) {
  for (std::size_t i = 0; i < S; ++i) {
    double sum = 0.0;
    for (std::size_t j = 0; j < S; ++j) {
      sum += t.a[i][j];
      EXPECT_TRUE(j < i || t.a[i][j] == 0.0) << "not explicit at " << i << ", " << j;
    }
    EXPECT_WITHIN(sum, t.c[i], kRounding) << "row " << i;
  }
}

TEST(Tableau, EveryRowSumsToItsNodeAndIsExplicit) {
  expectRowsSumToNodes(kRk4);
  expectRowsSumToNodes(kDopri5);
}

TEST(Rk4Tableau, MeetsTheConditionsOfOrderFourAndNotOfFive) {
  double worst_of_order_five = 0.0;
  for (const Tree& tree : treesOf(kRk4)) {
    const double defect = weighted(kRk4.b, tree.phi) - 1.0 / tree.density;
    if (tree.order == 5) {
      worst_of_order_five = std::max(worst_of_order_five, std::abs(defect));
    } else {
      EXPECT_WITHIN(defect, 0.0, kRounding) << tree.name;
    }
  }
  EXPECT_GT(worst_of_order_five, 1e-3);
}

TEST(Dopri5Tableau, MeetsTheConditionsOfOrderFive) {
  for (const Tree& tree : treesOf(kDopri5)) {
    EXPECT_WITHIN(weighted(kDopri5.b, tree.phi), 1.0 / tree.density, kRounding) << tree.name;
  }
}

TEST(Dopri5Tableau, EmbeddedWeightsMeetOrderFourAndNotOfFive) {
  double worst_of_order_five = 0.0;
  for (const Tree& tree : treesOf(kDopri5)) {
    const double defect = weighted(kDopri5Embedded, tree.phi) - 1.0 / tree.density;
    if (tree.order == 5) {
      worst_of_order_five = std::max(worst_of_order_five, std::abs(defect));
    } else {
      EXPECT_WITHIN(defect, 0.0, kRounding) << tree.name;
    }
  }
  EXPECT_GT(worst_of_order_five, 1e-4);
}

TEST(Dopri5Tableau, LastStageIsTheNewPoint) {
  EXPECT_EQ(kDopri5.a[6], kDopri5.b);
  EXPECT_EQ(kDopri5.c[6], 1.0);
}

TEST(Dopri5Dense, MeetsTheConditionsOfOrderFourEverywhereInTheStep) {
  for (int k = 0; k <= 20; ++k) {
    const double s = k / 20.0;
    std::array<double, 7> b;
    for (int i = 0; i < 7; ++i) b[static_cast<std::size_t>(i)] = dopri5DenseWeight(i, s);
    for (const Tree& tree : treesOf(kDopri5)) {
      if (tree.order > 4) continue;
      const double expected = std::pow(s, tree.order) / tree.density;
      EXPECT_WITHIN(weighted(b, tree.phi), expected, kRounding) << tree.name << " at " << s;
    }
  }
}

TEST(Dopri5Dense, JoinsTheStepsWithTheirSlopes) {
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(dopri5DenseWeight(i, 0.0), 0.0);
    EXPECT_EQ(dopri5DenseWeight(i, 1.0), kDopri5.b[static_cast<std::size_t>(i)]);
    // Central differences of a quartic: the error is the third derivative times d^2 / 6, 1e-9 here.
    const double d = 1e-5;
    const double at_begin = (dopri5DenseWeight(i, d) - dopri5DenseWeight(i, -d)) / (2 * d);
    const double at_end = (dopri5DenseWeight(i, 1 + d) - dopri5DenseWeight(i, 1 - d)) / (2 * d);
    EXPECT_WITHIN(at_begin, i == 0 ? 1.0 : 0.0, 1e-8) << i;
    EXPECT_WITHIN(at_end, i == 6 ? 1.0 : 0.0, 1e-8) << i;
  }
}

}  // namespace
}  // namespace vehicle
