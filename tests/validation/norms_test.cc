#include "libvehicle/validation/norms.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-14;  // sums of 2001 terms, each rounded once; the effects looked for are above 1e-9

/// amplitude sin(2 pi 5 t - shift) over whole periods, 2001 samples.
std::vector<double> sine(double amplitude, double shift) {
  std::vector<double> column;
  for (int i = 0; i <= 2000; ++i) column.push_back(amplitude * std::sin(2.0 * kPi * 5.0 * i / 2000.0 - shift));
  return column;
}

TEST(Norms, IdenticalColumnsDifferByNothing) {
  const Norms norms = compareColumns(sine(3.0, 0.2), sine(3.0, 0.2));
  EXPECT_EQ(norms.max_difference, 0.0);
  EXPECT_EQ(norms.nrmse, 0.0);
  EXPECT_WITHIN(norms.magnitude, 0.0, kRounding);
  EXPECT_WITHIN(norms.phase, 0.0, kRounding);
}

TEST(Norms, AScaledCopyHasMagnitudeErrorScaleMinusOneAndNoPhaseError) {
  for (const double scale : {0.25, 1.0 + 1e-9, 1.1, 4.0}) {
    const Norms norms = compareColumns(sine(2e-3, 0.0), sine(2e-3 * scale, 0.0));
    EXPECT_WITHIN(norms.magnitude, scale - 1.0, kRounding * scale);
    EXPECT_WITHIN(norms.phase, 0.0, kRounding);
    EXPECT_WITHIN(norms.combined, std::abs(scale - 1.0), kRounding * scale);
    EXPECT_WITHIN(norms.relative, std::abs(scale - 1.0), kRounding * scale);
    // Difference (s-1) A sin has r.m.s. |s-1| A/sqrt(2); the range of the reference is 2 A.
    EXPECT_WITHIN(norms.nrmse, std::abs(scale - 1.0) / (2.0 * std::sqrt(2.0)), kRounding * scale);
  }
}

// 1e-9 rad is far below what acos of a rounded cosine can see (1e-8).
TEST(Norms, AShiftedSineHasPhaseErrorShiftOverPiAndNoMagnitudeError) {
  for (const double shift : {1e-9, 1e-4, 0.3, kPi / 2.0, 3.0, kPi}) {
    const Norms norms = compareColumns(sine(7.0, 0.0), sine(7.0, shift));
    EXPECT_WITHIN(norms.phase, shift / kPi, kRounding);
    EXPECT_WITHIN(norms.magnitude, 0.0, kRounding);
  }
}

TEST(Norms, CombinedIsTheHypotenuseOfMagnitudeAndPhase) {
  const Norms norms = compareColumns(sine(1.0, 0.0), sine(1.3, 0.4 * kPi));
  EXPECT_WITHIN(norms.combined, std::hypot(0.3, 0.4), kRounding);
}

TEST(Norms, ZeroColumnsAreNotDividedBy) {
  const std::vector<double> zero(2001, 0.0);
  const Norms both = compareColumns(zero, zero);
  EXPECT_EQ(both.relative, 0.0);
  EXPECT_EQ(both.combined, 0.0);
  const Norms other = compareColumns(zero, sine(1.0, 0.0));
  EXPECT_WITHIN(other.max_difference, 1.0, kRounding);
  EXPECT_TRUE(std::isinf(other.relative));
  EXPECT_EQ(other.phase, 0.5);
  const Norms missing = compareColumns(sine(1.0, 0.0), zero);
  EXPECT_WITHIN(missing.relative, 1.0, kRounding);
  EXPECT_EQ(missing.magnitude, -1.0);
}

TEST(Norms, ColumnsBelowTheFloorCountAsZeroButKeepTheirDifference) {
  const Norms noise = compareColumns(sine(1e-18, 0.0), sine(3e-18, 2.0), 1e-16);
  EXPECT_EQ(noise.relative, 0.0);
  EXPECT_EQ(noise.combined, 0.0);
  EXPECT_GT(noise.max_difference, 2e-18);
}

TEST(Norms, TinyAndHugeValuesNeitherVanishNorOverflow) {
  for (const double scale : {1e-200, 1e200}) {
    const Norms norms = compareColumns(sine(scale, 0.0), sine(1.5 * scale, 0.3 * kPi));
    EXPECT_WITHIN(norms.magnitude, 0.5, kRounding);
    EXPECT_WITHIN(norms.phase, 0.3, kRounding);
  }
}

TEST(Norms, AValueThatIsNoNumberIsNeverWithinAnything) {
  std::vector<double> broken = sine(1.0, 0.0);
  broken[1000] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(compareColumns(sine(1.0, 0.0), broken).max_difference <= 1e300);
  EXPECT_FALSE(compareColumns(broken, sine(1.0, 0.0)).max_difference <= 1e300);
}

TEST(Norms, ColumnsOfDifferentLengthAreRefused) {
  EXPECT_THROW(static_cast<void>(compareColumns(std::vector<double>(3), std::vector<double>(4))),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(compareColumns(std::vector<double>(), std::vector<double>())), std::invalid_argument);
}

}  // namespace
}  // namespace vehicle
