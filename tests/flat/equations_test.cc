// The equations (2)-(5), their witness (7), and the printed variants.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/flat/first_order.h"
#include "libvehicle/flat/flat_form.h"
#include "tests/support/eigenvalues.h"
#include "tests/support/random_state.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]

// Half a unit of the last digit printed in docs/theory/errata.md.
void expectEigenvalues(FlatVariant variant, const std::vector<std::complex<double>>& expected) {
  const auto form = buildFlatForm(compile(paperVehicle(), kGravity), variant);
  const auto actual = test::oscillationsOf(form->linear().value().A);
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_WITHIN(actual[i].real(), expected[i].real(), 0.5e-6);
    EXPECT_WITHIN(actual[i].imag(), expected[i].imag(), 0.5e-6);
  }
}

TEST(Eigenvalues, OfTheConsistentEquationsAreTheDocumentedOnes) {
  expectEigenvalues(FlatVariant::kConsistent,
                    {{-0.883650, 7.932963}, {-3.143758, 21.635387}, {-9.759625, 29.906134}, {-25.567453, 28.927097}});
}

TEST(Eigenvalues, OfSevenWithThePrintedMappingAreTheDocumentedOnes) {
  expectEigenvalues(FlatVariant::kPrinted7,
                    {{-0.589725, 7.940819}, {-6.704444, 20.818745}, {-12.714369, 28.858011}, {-12.020030, 36.670900}});
}

TEST(Eigenvalues, OfTheLiteralEquationsAreTheDocumentedOnes) {
  expectEigenvalues(FlatVariant::kLiteral,
                    {{-0.008738, 0.888288}, {-1.475441, 8.009096}, {-21.442428, 23.763993}, {-3.676417, 35.021902}});
}

TEST(Eigenvalues, OfTheLiteralEquationsWithTheBogieMassMendedAreTheDocumentedOnes) {
  expectEigenvalues(FlatVariant::kLiteralMb,
                    {{-0.621480, 5.367527}, {-7.848439, 23.484715}, {-3.797220, 32.278533}, {-23.198457, 25.486298}});
}

/// (7) at a state in the inner order of the flat form.
std::array<double, 8> bySeven(const Equation7& seven, const std::array<double, 8>& inner,
                              const std::array<double, 8>& u) {
  constexpr std::array<std::size_t, 8> kPlace = {2, 6, 3, 7, 0, 4, 1, 5};  // z1 z1' z2 z2' zk zk' phi phi'
  std::array<double, 8> dx{};
  for (std::size_t row = 0; row < 8; ++row) {
    for (std::size_t col = 0; col < 8; ++col) {
      dx[kPlace[row]] += seven.A[row][col] * inner[kPlace[col]] + seven.B[row][col] * u[col];
    }
  }
  return dx;
}

// Two ways to sum the same dozen products: a few roundings of the largest acceleration.
TEST(EquationSeven, WithTheConsistentMappingIsTwoToFive) {
  const auto form = buildFlatForm(compile(paperVehicle(), kGravity));
  const Equation7 seven = equation7(lettersOf(form->parameters(), Mapping::kConsistent));
  for (const RandomState& state : randomStates(1000, 8, 4)) {
    std::array<double, 8> x{}, u{}, dx{};
    std::copy_n(state.x.begin(), 8, x.begin());
    std::copy_n(state.u.begin(), 8, u.begin());
    (*form->rhs())(x.data(), u.data(), dx.data());
    const std::array<double, 8> witness = bySeven(seven, x, u);
    double largest = 0.0;
    for (const double each : dx) largest = std::max(largest, std::abs(each));
    for (std::size_t i = 0; i < 8; ++i) EXPECT_WITHIN(dx[i], witness[i], 1e-14 * largest);
  }
}

// Entry by entry, so that no sum hides a small one.
TEST(EquationSeven, HasTheMatricesOfTwoToFive) {
  const auto form = buildFlatForm(compile(paperVehicle(), kGravity));
  const StateSpace matrices = form->linear().value();
  const Equation7 seven = equation7(lettersOf(form->parameters(), Mapping::kConsistent));
  constexpr std::array<Eigen::Index, 8> kPlace = {2, 6, 3, 7, 0, 4, 1, 5};
  for (std::size_t row = 0; row < 8; ++row) {
    for (std::size_t col = 0; col < 8; ++col) {
      // Products of four factors in another order.
      const double a = seven.A[row][col];
      EXPECT_WITHIN(matrices.A(kPlace[row], kPlace[col]), a, 1e-15 * std::abs(a)) << row << ' ' << col;
      const double b = seven.B[row][col];
      EXPECT_WITHIN(matrices.B(kPlace[row], static_cast<Eigen::Index>(col)), b, 1e-15 * std::abs(b))
          << row << ' ' << col;
    }
  }
}

double carbodyForceAfterLift(FlatVariant variant) {
  const auto form = buildFlatForm(compile(paperVehicle(), kGravity), variant);
  const double h = 1e-3;
  const std::array<double, 8> x = {h, 0, h, h, 0, 0, 0, 0};
  const std::array<double, 8> u = {h, h, h, h, 0, 0, 0, 0};
  std::array<double, 8> dx{};
  form->derivative(x, u, dx);
  return 57e3 * dx[4];
}

// Lifting bodies and rail by 1 mm; forces are differences of terms of 6 kN, rounding 1e-12 N.
TEST(UniformLift, LeavesNoForceInTheConsistentEquations) {
  const auto form = buildFlatForm(compile(asymmetricVehicle(), kGravity));
  std::vector<double> x(8, 0.0), u(8, 0.0), dx(8);
  for (const std::size_t z : {0u, 1u, 3u}) x[z] = 1e-3;  // rear_bogie.z, carbody.z, front_bogie.z
  std::fill_n(u.begin(), 4, 1e-3);
  form->derivative(x, u, dx);
  for (const double each : dx) EXPECT_WITHIN(each, 0.0, 1e-15);
  EXPECT_WITHIN(carbodyForceAfterLift(FlatVariant::kConsistent), 0.0, 1e-11);
  EXPECT_WITHIN(carbodyForceAfterLift(FlatVariant::kPrinted7), 0.0, 1e-11);
}

// Errata row 1: the printed spring of (2), 2 ck (zk - z1 - z2), leaves 2 ck h upward at a lift h.
TEST(UniformLift, LeavesAForceInTheLiteralEquations) {
  EXPECT_WITHIN(carbodyForceAfterLift(FlatVariant::kLiteral), 2 * 2660e3 * 1e-3, 1e-9);
}

// zk'' of a pure phi is zero in the symmetric vehicle: that is why the paper's (2) has no phi.
TEST(SymmetricVehicle, DecouplesBounceFromPitch) {
  const StateSpace matrices = buildFlatForm(compile(paperVehicle(), kGravity))->linear().value();
  EXPECT_EQ(matrices.A(4, 1), 0.0);
  EXPECT_EQ(matrices.A(4, 5), 0.0);
  EXPECT_EQ(matrices.A(5, 0), 0.0);
  EXPECT_EQ(matrices.A(5, 4), 0.0);
}

/// Two designs side by side in one SSE2 register, as an ensemble will have more of them.
using Pack = double __attribute__((vector_size(16)));

FlatCoefficients<Pack> pairOf(const FlatCoefficients<double>& a, const FlatCoefficients<double>& b) {
  static_assert(sizeof(FlatCoefficients<double>) % sizeof(double) == 0);
  constexpr std::size_t kCount = sizeof(FlatCoefficients<double>) / sizeof(double);
  std::array<double, kCount> one{}, other{};
  std::memcpy(one.data(), &a, sizeof a);
  std::memcpy(other.data(), &b, sizeof b);
  std::array<Pack, kCount> both{};
  for (std::size_t i = 0; i < kCount; ++i) both[i] = Pack{one[i], other[i]};
  FlatCoefficients<Pack> made;
  static_assert(sizeof made == sizeof both);
  std::memcpy(&made, both.data(), sizeof made);
  return made;
}

// The same source line for a number and for a pack of them: with contraction off, each lane has the scalar's bits.
TEST(Equations, GiveEveryLaneOfASimdPackTheBitsOfDouble) {
  const FlatParameters second = {.mk = 48e3, .Jk = 310e3, .m1 = 10.2e3, .m2 = 7.5e3, .lf = 3.7, .lr = 4.8,
                                 .cs1 = 3.1e6, .bs1 = 60e3, .cs2 = 1.9e6, .bs2 = 85e3,
                                 .cp = {2.7e6, 3.4e6, 2.2e6, 3.9e6}, .bp = {21e3, 33e3, 45e3, 12e3}, .k_g = -2e5};
  const FlatParameters first = buildFlatForm(compile(paperVehicle(), kGravity))->parameters();
  const FlatCoefficients<Pack> p = pairOf(coefficientsOf(first), coefficientsOf(second));
  const RandomState state = randomStates(1, 8, 4).front();
  const auto lanes = [](double value) { return Pack{value, value}; };
  const auto& x = state.x;
  const auto& u = state.u;
  const FlatState<Pack> s{lanes(x[0]), lanes(x[1]), lanes(x[2]), lanes(x[3]),
                          lanes(x[4]), lanes(x[5]), lanes(x[6]), lanes(x[7])};
  const FlatRail<Pack> rail{lanes(u[0]), lanes(u[1]), lanes(u[2]), lanes(u[3]),
                            lanes(u[4]), lanes(u[5]), lanes(u[6]), lanes(u[7])};
  const std::array<Pack, 4> packed = {carbodyBounce(p, s), carbodyPitch(p, s), frontBogieBounce(p, s, rail),
                                      rearBogieBounce(p, s, rail)};
  const std::array<FlatRhs, 2> designs = {FlatRhs(first), FlatRhs(second)};
  for (std::size_t lane = 0; lane < 2; ++lane) {
    std::array<double, 8> dx{};
    designs[lane](x.data(), u.data(), dx.data());
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(packed[i][lane], dx[i + 4]) << lane << ' ' << i;
  }
}

}  // namespace
}  // namespace vehicle::test
