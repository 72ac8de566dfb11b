#include "libvehicle/validation/sensitivity.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

/// x'' + 2 zeta w x' + w^2 x = w^2 eta; columns x, x'.
class Oscillator : public System {
 public:
  Oscillator(double w, double zeta) : w_(w), zeta_(zeta) {}
  int channels() const override { return 1; }
  StateLayout layout() const override { return {.coordinates = 1}; }
  const std::vector<Channel>& states() const override { return channels_; }
  const std::vector<Channel>& outputs() const override { return channels_; }
  void derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const override {
    dx[0] = x[1];
    dx[1] = -2.0 * zeta_ * w_ * x[1] - w_ * w_ * (x[0] - u[0]);
  }
  void output(std::span<const double> x, std::span<const double>, std::span<double> y) const override {
    y[0] = x[0];
    y[1] = x[1] + 5.0;  // a column that is not zero at rest
  }
  std::optional<StateSpace> linear() const override {
    StateSpace made;
    made.A = Eigen::MatrixXd{{0.0, 1.0}, {-w_ * w_, -2.0 * zeta_ * w_}};
    made.B = Eigen::MatrixXd{{0.0, 0.0}, {w_ * w_, 0.0}};
    return made;
  }

 private:
  double w_, zeta_;
  std::vector<Channel> channels_ = {{"mass.z", "m"}, {"mass.vz", "m/s"}};
};

// Force to displacement: the impulse response exp(-zeta w t) sin(wd t) / wd has the 1-norm
// coth(zeta pi / (2 sqrt(1 - zeta^2))) / w^2.
// Tolerance 1 %: trapezoidal rule with 0.2 rad a step on |sin|, breakpoints included (0.2^2/12 = 0.3 %), and the tail
// after 14 time constants (1e-6).
TEST(Sensitivity, OfAnOscillatorIsTheOneNormOfItsImpulseResponse) {
  for (const double zeta : {0.05, 0.2, 0.5}) {
    const double w = 7.0;
    const Sensitivity sensitivity = sensitivityOf(Oscillator(w, zeta), 1000.0);
    const double exact = 1.0 / std::tanh(zeta * std::numbers::pi / (2.0 * std::sqrt(1.0 - zeta * zeta))) / (w * w);
    EXPECT_WITHIN(sensitivity.L(0, 1) / exact, 1.0, 0.01);
  }
}

// |sin| / w integrated over T = 10 periods of an undamped oscillator: 2 T / (pi w). Same tolerance.
TEST(Sensitivity, OfAnUndampedOscillatorGrowsWithTheDuration) {
  const double w = 3.0, duration = 10.0 * 2.0 * std::numbers::pi / w;
  const Sensitivity sensitivity = sensitivityOf(Oscillator(w, 0.0), duration);
  EXPECT_WITHIN(sensitivity.L(0, 1) * std::numbers::pi * w / (2.0 * duration), 1.0, 0.01);
}

TEST(Sensitivity, SeparatesWhatAStateDoesToAColumnFromWhatIsThereAtRest) {
  const Sensitivity sensitivity = sensitivityOf(Oscillator(2.0, 0.1), 1.0);
  EXPECT_EQ(sensitivity.C, Eigen::MatrixXd::Identity(2, 2));
  EXPECT_EQ(sensitivity.static_output(1), 5.0);
  EXPECT_EQ(sensitivity.D, Eigen::MatrixXd::Zero(2, 3));
}

TEST(Sensitivity, ADurationThatIsNotPositiveIsRefused) {
  EXPECT_THROW(static_cast<void>(sensitivityOf(Oscillator(1.0, 0.1), 0.0)), std::invalid_argument);
}

}  // namespace
}  // namespace vehicle
