#include "libvehicle/system/system.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

// A mass on a spring that stiffens, over one wheel:  x1' = x2,  x2' = -4 x1 - hard x1^3 - 0.5 x2 + 4 eta + 0.5 eta'.
class StiffeningMass final : public System {
 public:
  explicit StiffeningMass(double hard) : hard_(hard) {}
  int channels() const override { return 1; }
  StateLayout layout() const override { return {.coordinates = 1}; }
  const std::vector<Channel>& states() const override { return states_; }
  const std::vector<Channel>& outputs() const override { return states_; }
  void derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const override {
    dx[0] = x[1];
    dx[1] = -4.0 * x[0] - hard_ * x[0] * x[0] * x[0] - 0.5 * x[1] + 4.0 * u[0] + 0.5 * u[1];
  }
  void output(std::span<const double> x, std::span<const double>, std::span<double> y) const override {
    y[0] = x[0];
    y[1] = x[1];
  }

 private:
  double hard_;
  std::vector<Channel> states_{{"mass.z", "m"}, {"mass.vz", "m/s"}};
};

TEST(DifferencedStateSpace, OfALinearSystemIsExactForAnyScale) {
  const StiffeningMass mass(0.0);
  for (const double scale : {1e-3, 1.0, 10.0}) {
    const StateSpace found = differencedStateSpace(mass, std::vector{0.2, -0.3}, std::vector{0.1, 0.4}, scale);
    // Rounding of f (order 1) over the perturbation.
    const double tolerance = 1e-15 * (1.0 + 1.0 / scale) * 4.0;
    EXPECT_WITHIN(found.A(0, 0), 0.0, tolerance);
    EXPECT_WITHIN(found.A(0, 1), 1.0, tolerance);
    EXPECT_WITHIN(found.A(1, 0), -4.0, tolerance);
    EXPECT_WITHIN(found.A(1, 1), -0.5, tolerance);
    EXPECT_WITHIN(found.B(0, 0), 0.0, tolerance);
    EXPECT_WITHIN(found.B(1, 0), 4.0, tolerance);
    EXPECT_WITHIN(found.B(1, 1), 0.5, tolerance);
  }
}

// d/dx of hard x^3 differenced over +-s is hard (3 x^2 + s^2): the error is hard s^2 to the digit.
TEST(DifferencedStateSpace, OfANonlinearSystemErrsByTheSquareOfTheScale) {
  const StiffeningMass mass(7.0);
  for (const double scale : {1e-1, 1e-2}) {
    const StateSpace found = differencedStateSpace(mass, std::vector{0.2, 0.0}, std::vector{0.0, 0.0}, scale);
    EXPECT_WITHIN(found.A(1, 0), -4.0 - 7.0 * (3.0 * 0.04 + scale * scale), 1e-13);  // rounding 1e-16 / scale
  }
}

TEST(DifferencedStateSpace, RefusesWrongShapesAndScales) {
  const StiffeningMass mass(0.0);
  const std::vector<double> two(2, 0.0), three(3, 0.0);
  EXPECT_THROW((void)differencedStateSpace(mass, three, two, 1.0), std::invalid_argument);
  EXPECT_THROW((void)differencedStateSpace(mass, two, three, 1.0), std::invalid_argument);
  EXPECT_THROW((void)differencedStateSpace(mass, two, two, 0.0), std::invalid_argument);
}

TEST(System, WithoutMatricesSaysSo) { EXPECT_FALSE(StiffeningMass(1.0).linear().has_value()); }

}  // namespace
}  // namespace vehicle
