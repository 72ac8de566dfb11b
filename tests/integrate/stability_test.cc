#include "libvehicle/integrate/stability.h"

#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

using Complex = std::complex<double>;

// A method of order p has R(z) = sum z^i / i! up to i = p; the classical one nothing beyond, Dormand and Prince's z^6 /
// 600.
TEST(StabilityFunction, IsTheTaylorPolynomialOfTheOrder) {
  for (const Complex z : {Complex(-1.3, 0.0), Complex(-0.4, 2.1), Complex(0.0, 1.0)}) {
    const Complex rk4 = 1.0 + z + z * z / 2.0 + z * z * z / 6.0 + z * z * z * z / 24.0;
    const Complex dopri5 = rk4 + std::pow(z, 5) / 120.0 + std::pow(z, 6) / 600.0;
    // Rounding of sums of terms below 10.
    EXPECT_WITHIN(std::abs(stabilityFunction(kRk4, z) - rk4), 0.0, 1e-14);
    EXPECT_WITHIN(std::abs(stabilityFunction(kDopri5, z) - dopri5), 0.0, 1e-13);
  }
}

// |R(iy)|^2 = 1 - y^6 / 72 + y^8 / 576 of the classical method: 1 again at y = sqrt(8), and more beyond.
TEST(StabilityFunction, LeavesTheUnitDiscWhereTheBooksSay) {
  const double border = std::sqrt(8.0);
  EXPECT_WITHIN(std::abs(stabilityFunction(kRk4, {0.0, border})), 1.0, 1e-14);  // rounding
  EXPECT_LT(std::abs(stabilityFunction(kRk4, {0.0, 0.999 * border})), 1.0);
  EXPECT_GT(std::abs(stabilityFunction(kRk4, {0.0, 1.001 * border})), 1.0);
  // Hairer, Wanner II, fig. IV.2.1: Dormand and Prince's region reaches to about -3.3.
  EXPECT_LT(std::abs(stabilityFunction(kDopri5, -3.3)), 1.0);
  EXPECT_GT(std::abs(stabilityFunction(kDopri5, -3.32)), 1.0);
}

// The first term that Dormand and Prince's method has wrong: z^6 (1/600 - 1/720) = z^6 / 3600.
TEST(ModeError, FallsWithTheSixthPowerOfTheStep) {
  const Complex z(-0.02, 0.05);
  // The next term is |z| / 7 of it, of opposite sign or other phase: 1 %.
  EXPECT_WITHIN(modeError(kDopri5, z) / std::pow(std::abs(z), 6), 1.0 / 3600.0, 0.1 / 3600.0);
  EXPECT_EQ(modeError(kDopri5, 0.0), 0.0);
}

}  // namespace
}  // namespace vehicle
