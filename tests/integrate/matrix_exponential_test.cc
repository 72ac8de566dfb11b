#include "libvehicle/integrate/matrix_exponential.h"

#include <cmath>
#include <stdexcept>

#include <Eigen/LU>

#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

TEST(MatrixExponential, NilpotentChainGivesTheTaylorTerms) {
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  for (int i = 0; i < 3; ++i) A(i, i + 1) = 0.7;
  const Eigen::MatrixXd E = matrixExponential(A);
  const double term[4] = {1.0, 0.7, 0.7 * 0.7 / 2.0, 0.7 * 0.7 * 0.7 / 6.0};
  for (int i = 0; i < 4; ++i) {
    // A few roundings of numbers of order one.
    for (int j = 0; j < 4; ++j) EXPECT_WITHIN(E(i, j), j < i ? 0.0 : term[j - i], 1e-15) << i << ", " << j;
  }
}

TEST(MatrixExponential, SkewMatrixRotatesWithoutGrowing) {
  for (const double angle : {1e-9, 0.3, 5.0, 100.0}) {
    const Eigen::MatrixXd E = matrixExponential(Eigen::Matrix2d{{0.0, -angle}, {angle, 0.0}});
    // The argument's rounding is 1.1e-16 angle; the squarings (5 for 100 rad) double the rounding each time.
    const double tolerance = 1e-15 * (1.0 + angle);
    EXPECT_WITHIN(E(0, 0), std::cos(angle), tolerance) << angle;
    EXPECT_WITHIN(E(1, 0), std::sin(angle), tolerance) << angle;
    EXPECT_WITHIN(E(0, 1), -std::sin(angle), tolerance) << angle;
  }
}

TEST(MatrixExponential, DiagonalOfAllSizes) {
  const Eigen::Vector4d d(-700.0, -3.0, 0.0, 4.0);
  const Eigen::MatrixXd E = matrixExponential(d.asDiagonal());
  for (int i = 0; i < 4; ++i) EXPECT_WITHIN(E(i, i), std::exp(d(i)), 1e-14 * std::max(1.0, std::exp(d(i)))) << i;
}

TEST(MatrixExponential, OfCommutingSumIsTheProduct) {
  const Eigen::Matrix3d A{{0.1, 0.4, -0.2}, {0.0, -0.3, 0.5}, {0.7, 0.2, 0.1}};
  const Eigen::Matrix3d B = 0.6 * A * A - 1.1 * A;
  const Eigen::MatrixXd difference = matrixExponential(A + B) - matrixExponential(A) * matrixExponential(B);
  EXPECT_WITHIN(difference.cwiseAbs().maxCoeff(), 0.0, 1e-14);  // roundings of numbers up to 3
}

TEST(MatrixExponential, DeterminantIsTheExponentialOfTheTrace) {
  const Eigen::Matrix3d A{{-2.0, 14.0, 3.0}, {-9.0, -1.5, 6.0}, {0.5, -7.0, -3.0}};
  // |A| = 22: two squarings, and the determinant is a sum of products of entries up to 3 that cancel to 1.5e-3.
  EXPECT_WITHIN(matrixExponential(A).determinant(), std::exp(-6.5), 1e-13);
}

TEST(MatrixExponential, KeepsTheDigitsOfAShortStep) {
  const double a = 3e-9;
  const Eigen::MatrixXd E = expMinusIdentity(Eigen::Matrix2d{{-a, 0.0}, {0.0, a}});
  // Through e^A first, 1e-16 of 1 would be 3e-8 of this.
  EXPECT_WITHIN(E(0, 0), std::expm1(-a), 1e-15 * a);
  EXPECT_WITHIN(E(1, 1), std::expm1(a), 1e-15 * a);
}

// A wheelset of 1.8 t on a contact spring of 2.4 GN/m, 5 ms: w = 1155 rad/s, A spans nine decades.
TEST(MatrixExponential, StiffContactSpringAgreesWithTheClosedFormWhenBalanced) {
  const double h = 5e-3, w2 = 2.4e9 / 1.8e3, c = 20e3 / 1.8e3;
  const Eigen::Matrix2d A{{0.0, 1.0}, {-w2, -c}};
  const Eigen::VectorXd d = balancingScales(A);
  const Eigen::MatrixXd E =
      d.asDiagonal() * matrixExponential(h * d.cwiseInverse().asDiagonal() * A * d.asDiagonal()) *
      d.cwiseInverse().asDiagonal();
  const double sigma = c / 2, wd = std::sqrt(w2 - sigma * sigma), decay = std::exp(-sigma * h);
  const double cosine = std::cos(wd * h), sine = std::sin(wd * h);
  // |A h| = 6 when balanced: one squaring; entries relative to the size that their units give them.
  EXPECT_WITHIN(E(0, 0), decay * (cosine + sigma / wd * sine), 1e-14);
  EXPECT_WITHIN(E(0, 1), decay * sine / wd, 1e-14 / wd);
  EXPECT_WITHIN(E(1, 0), -decay * w2 / wd * sine, 1e-14 * wd);
  EXPECT_WITHIN(E(1, 1), decay * (cosine - sigma / wd * sine), 1e-14);
}

TEST(MatrixExponential, RefusesWhatHasNone) {
  EXPECT_THROW((void)matrixExponential(Eigen::MatrixXd::Zero(2, 3)), std::invalid_argument);
  EXPECT_THROW((void)matrixExponential(Eigen::MatrixXd::Constant(2, 2, std::nan(""))), std::invalid_argument);
}

TEST(BalancingScales, BringRowsAndColumnsToOneSizeByPowersOfTwo) {
  Eigen::Matrix3d A{{1.0, 1e-6, 0.0}, {4e6, 2.0, 3e5}, {0.0, 1e-4, 1.0}};
  const Eigen::VectorXd d = balancingScales(A);
  A = d.cwiseInverse().asDiagonal() * A * d.asDiagonal();
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(std::log2(d(i)), std::round(std::log2(d(i))));
    const double own = std::abs(A(i, i));
    const double ratio = (A.row(i).cwiseAbs().sum() - own) / (A.col(i).cwiseAbs().sum() - own);
    // A power of two on the row and one on the column: a ratio within 4 either way is the best there is.
    EXPECT_LT(ratio, 4.0) << i;
    EXPECT_GT(ratio, 0.25) << i;
  }
}

TEST(BalancingScales, OneWayPartsStayFinite) {
  const Eigen::Matrix2d free_mass{{0.0, 1.0}, {0.0, 0.0}};
  EXPECT_TRUE(balancingScales(free_mass).allFinite());
  EXPECT_WITHIN(matrixExponential(free_mass)(0, 1), 1.0, 1e-15);  // a few roundings
}

}  // namespace
}  // namespace vehicle
