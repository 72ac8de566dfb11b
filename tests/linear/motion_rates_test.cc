#include "libvehicle/linear/motion_rates.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

Eigen::MatrixXd oscillator(double w, double zeta) { return Eigen::MatrixXd{{0.0, 1.0}, {-w * w, -2.0 * zeta * w}}; }

/// N masses of 1 kg in a row, each tied to its neighbours by springs k, the ends to the ground: angular frequencies
/// 2 sqrt(k) sin(i pi / (2 (N + 1))), i = 1 .. N.
class Chain : public System {
 public:
  Chain(int masses, double stiffness) : N_(static_cast<std::size_t>(masses)), k_(stiffness) {
    for (std::size_t i = 0; i < N_; ++i) channels_.push_back({std::string("m").append(std::to_string(i)).append(".z"), "m"});
    for (std::size_t i = 0; i < N_; ++i) channels_.push_back({std::string("m").append(std::to_string(i)).append(".vz"), "m/s"});
  }
  int channels() const override { return 0; }
  StateLayout layout() const override { return {.coordinates = static_cast<int>(N_)}; }
  const std::vector<Channel>& states() const override { return channels_; }
  const std::vector<Channel>& outputs() const override { return channels_; }
  void derivative(std::span<const double> x, std::span<const double>, std::span<double> dx) const override {
    for (std::size_t i = 0; i < N_; ++i) {
      dx[i] = x[N_ + i];
      dx[N_ + i] = k_ * ((i > 0 ? x[i - 1] : 0.0) - 2.0 * x[i] + (i + 1 < N_ ? x[i + 1] : 0.0));
    }
  }
  void output(std::span<const double> x, std::span<const double>, std::span<double> y) const override {
    std::copy(x.begin(), x.end(), y.begin());
  }

 private:
  std::size_t N_;
  double k_;
  std::vector<Channel> channels_;
};

TEST(MotionRates, KnowTheFastestMotionAndHowFarApartMotionsLie) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(4, 4);
  A.topRightCorner(2, 2).setIdentity();
  A(2, 0) = -9.0;      // 3 rad/s
  A(3, 1) = -90000.0;  // 300 rad/s
  const MotionRates rates(A);
  EXPECT_WITHIN(rates.fastest(), 300.0, 1e-12 * 300.0);
  EXPECT_WITHIN(rates.spread(), 100.0, 1e-10 * 100.0);
  EXPECT_EQ(rates.growth(), 0.0);
}

// A damper of any size moves no natural frequency of the undamped system.
TEST(MotionRates, AnEnormousDamperStandsFarFromEverything) {
  const double c = 1e20;
  const Eigen::MatrixXd A{{0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, 0.0, 1.0}, {-16.0, 0.0, -c, c}, {0.0, -9.0, c, -c}};
  const MotionRates rates(A);
  EXPECT_WITHIN(rates.spread(), 2.0 * c / 3.0, 1e-9 * c);
  EXPECT_WITHIN(rates.fastestToShow(), MotionRates::kDecays * 4.0, 1e-12 * 80.0);  // what decays at once asks for none
}

// Beyond kMostStates by iteration: modes lie close together there, so it comes within some percent from below.
TEST(MotionRates, OfVeryManyStatesComeFromIteration) {
  const Chain chain(200, 2500.0);
  const double exact = 2.0 * 50.0 * std::sin(200.0 * std::numbers::pi / 402.0);
  EXPECT_WITHIN(MotionRates(chain).fastest(), exact, 0.03 * exact);
}

TEST(MotionRates, SeeAGrowingMotionAndNotWhatRoundingMakesOfAnUndampedOne) {
  EXPECT_WITHIN(MotionRates(oscillator(4.0, -0.1)).growth(), 0.4, 1e-12);
  EXPECT_EQ(MotionRates(oscillator(4.0, 0.0)).growth(), 0.0);
  EXPECT_WITHIN(MotionRates(Eigen::MatrixXd{{0.0, 1.0}, {25.0, 0.0}}).growth(), 5.0, 1e-12);  // tips over
}

// 120 * 0.05 / (T w^5) to the power 1/4 for an undamped mode; rounding of pow and of the eigenvalue.
TEST(ResolvingRk4Step, OfAnUndampedModeFollowsFromItsLossOverTheRun) {
  const double w = 3.0, duration = 40.0;
  EXPECT_WITHIN(MotionRates(oscillator(w, 0.0)).resolvingRk4Step(duration),
                std::pow(6.0 / (duration * std::pow(w, 5)), 0.25), 1e-12);
}

// rk4 is stable on the real axis up to h |lambda| = 2.785.
TEST(ResolvingRk4Step, IsStableOnTheRealAxis) {
  const Eigen::MatrixXd A{{-100.0, 0.0}, {0.0, -1.0}};
  EXPECT_LT(MotionRates(A).resolvingRk4Step(10.0) * 100.0, 1.6);
}

TEST(ResolvingRk4Step, AMotionWithoutStiffnessAsksForNothing) {
  EXPECT_TRUE(std::isinf(MotionRates(Eigen::MatrixXd{{0.0, 1.0}, {0.0, 0.0}}).resolvingRk4Step(10.0)));
}

// The limits of stability of the classical method: sqrt(8) on the imaginary axis, 2.7853 on the real one.
TEST(Rk4Grows, BeyondTheLimitsOfStability) {
  const double w = 10.0;
  EXPECT_FALSE(MotionRates(oscillator(w, 0.0)).rk4Grows(0.999 * std::sqrt(8.0) / w));
  EXPECT_TRUE(MotionRates(oscillator(w, 0.0)).rk4Grows(1.001 * std::sqrt(8.0) / w));
  const Eigen::MatrixXd real{{-w, 0.0}, {0.0, -1.0}};
  EXPECT_FALSE(MotionRates(real).rk4Grows(2.785 / w));
  EXPECT_TRUE(MotionRates(real).rk4Grows(2.786 / w));
  EXPECT_FALSE(MotionRates(oscillator(w, -0.1)).rk4Grows(1e-3)) << "the vehicle grows, the method does not";
}

}  // namespace
}  // namespace vehicle
