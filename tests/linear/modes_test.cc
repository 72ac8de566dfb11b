#include "libvehicle/linear/modes.h"

#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

#include "tests/linear/coach.h"
#include "tests/support/tolerance.h"

namespace vehicle::test {
namespace {

using Complex = std::complex<double>;

/// |(lambda^2 M + lambda C + K) q| relative to the largest of its three terms.
double residual(const Mode& mode, const Eigen::MatrixXd& A) {
  const Eigen::Index N = mode.shape.size();
  Eigen::VectorXcd x(2 * N);
  x << mode.shape, mode.eigenvalue * mode.shape;
  const Eigen::VectorXcd left = A.cast<Complex>() * x - mode.eigenvalue * x;
  return left.norm() / (A.norm() * x.norm());
}

// docs/theory/errata.md: eigenvalues of the consistent equations, Jk = 70 t m^2, to the six decimals printed there.
TEST(ModesOf, PaperVehicleHasThePublishedEigenvalues) {
  const std::vector<Mode> modes = modesOf(paperMatrices().A, paperStates());
  const Complex expected[] = {
      {-0.883650, 7.932963}, {-3.143758, 21.635387}, {-9.759625, 29.906134}, {-25.567453, 28.927097}};
  ASSERT_EQ(modes.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_WITHIN(modes[i].eigenvalue.real(), expected[i].real(), 5.1e-7);  // half the last digit printed
    EXPECT_WITHIN(modes[i].eigenvalue.imag(), expected[i].imag(), 5.1e-7);
    EXPECT_DOUBLE_EQ(modes[i].frequency, std::abs(modes[i].eigenvalue) / (2.0 * std::numbers::pi));
    EXPECT_DOUBLE_EQ(modes[i].damping_ratio, -modes[i].eigenvalue.real() / std::abs(modes[i].eigenvalue));
    EXPECT_EQ(modes[i].multiplicity, 1);
    EXPECT_WITHIN(residual(modes[i], paperMatrices().A), 0.0, 1e-15 * 8);  // backward error of the solver
    EXPECT_WITHIN(modes[i].participation.sum(), 1.0, 1e-14);
  }
}

// With Jk = 70 tf m s^2 the carbody alone pitches at sqrt(2 ak^2 ck / Jk) = 10.4 rad/s and the bogies alone bounce at
// sqrt((ck + 2 cb) / mb) = 31.2: each mode has its owner.
TEST(ModesOf, PaperVehicleModesAreNamedByWhatMoves) {
  const std::vector<Mode> modes = modesOf(paperMatrices(70.0 * 9806.65).A, paperStates());
  EXPECT_EQ(modes[0].name, "carbody bounce");
  EXPECT_EQ(modes[1].name, "carbody pitch");
  EXPECT_EQ((std::set<std::string>{modes[2].name, modes[3].name}),
            (std::set<std::string>{"front_bogie + rear_bogie bounce in phase",
                                   "front_bogie + rear_bogie bounce in antiphase"}));
}

// With Jk = 70 t m^2 the carbody alone would pitch at 32.5 rad/s, above the bogies' 31.2: of the two coupled modes the
// lower one belongs to the bogies.
TEST(ModesOf, LightCarbodyLeavesTheLowerAntiphaseModeToTheBogies) {
  const std::vector<Mode> modes = modesOf(paperMatrices().A, paperStates());
  EXPECT_EQ(modes[0].name, "carbody bounce");
  EXPECT_EQ(modes[1].name, "front_bogie + rear_bogie bounce in antiphase");
  EXPECT_EQ(modes[2].name, "front_bogie + rear_bogie bounce in phase");
  EXPECT_EQ(modes[3].name, "carbody pitch");
  // The symmetric vehicle separates bounce and pitch: shapes are pure.
  EXPECT_WITHIN(std::abs(modes[0].shape(1)), 0.0, 1e-13);
  EXPECT_WITHIN(std::abs(modes[0].shape(2) - modes[0].shape(3)), 0.0, 1e-13);
  EXPECT_WITHIN(std::abs(modes[1].shape(0)), 0.0, 1e-13);
  EXPECT_WITHIN(std::abs(modes[1].shape(2) + modes[1].shape(3)), 0.0, 1e-13);
}

// Two equal masses, each on k and c to the ground, joined by kc and cc: the mean moves on (k, c), the difference on
// (k + 2 kc, c + 2 cc).
TEST(ModesOf, TwoMassesMoveInPhaseAndInAntiphase) {
  const double m = 9e3, k = 3e6, c = 30e3, kc = 1e6, cc = 20e3;
  const Eigen::Matrix2d K{{k + kc, -kc}, {-kc, k + kc}}, C{{c + cc, -cc}, {-cc, c + cc}};
  const auto modes = modesOf(stateMatrix(m * Eigen::Matrix2d::Identity(), C, K), statesOf({"a.z", "b.z"}));
  ASSERT_EQ(modes.size(), 2u);
  const double w1 = std::sqrt(k / m), w2 = std::sqrt((k + 2 * kc) / m);
  // Relative to the stiffest frequency: the solver's backward error.
  EXPECT_WITHIN(modes[0].frequency, w1 / (2 * std::numbers::pi), 1e-14 * w2);
  EXPECT_WITHIN(modes[0].damping_ratio, c / (2 * m * w1), 1e-14);
  EXPECT_WITHIN(modes[1].frequency, w2 / (2 * std::numbers::pi), 1e-14 * w2);
  EXPECT_WITHIN(modes[1].damping_ratio, (c + 2 * cc) / (2 * m * w2), 1e-14);
  EXPECT_WITHIN(std::abs(modes[0].shape(1) / modes[0].shape(0) - 1.0), 0.0, 1e-13);
  EXPECT_WITHIN(std::abs(modes[1].shape(1) / modes[1].shape(0) + 1.0), 0.0, 1e-13);
  EXPECT_EQ(modes[0].name, "a + b bounce in phase");
  EXPECT_EQ(modes[1].name, "a + b bounce in antiphase");
}

TEST(ModesOf, TwoEqualBogiesPitchOneByOneAtOneEigenvalue) {
  const std::vector<Mode> modes = modesOf(coachMatrix(), coachStates());
  ASSERT_EQ(modes.size(), 6u);
  const double w = std::sqrt(2 * 1.28 * 1.28 * 2440e3 / 1476), damping = 1.28 * 1.28 * 8e3 / (1476 * w);
  for (std::size_t i : {4u, 5u}) {
    EXPECT_EQ(modes[i].multiplicity, 2);
    EXPECT_WITHIN(modes[i].frequency, w / (2 * std::numbers::pi), 1e-13 * w);
    EXPECT_WITHIN(modes[i].damping_ratio, damping, 1e-13);
  }
  EXPECT_EQ(modes[4].name, "front_bogie pitch");
  EXPECT_EQ(modes[5].name, "rear_bogie pitch");
  // Independent shapes: one coordinate each.
  EXPECT_WITHIN(modes[4].participation(3), 1.0, 1e-10);
  EXPECT_WITHIN(modes[5].participation(5), 1.0, 1e-10);
}

TEST(ModesOf, NearlyEqualModesStayApart) {
  const std::vector<Mode> modes = modesOf(coachMatrix(), coachStates());
  // The bogies' bounce in phase and in antiphase lie 0.2 % apart, far beyond rounding.
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(modes[i].multiplicity, 1);
  EXPECT_GT(modes[3].frequency - modes[2].frequency, 0.005);
  EXPECT_EQ(modes[0].name, "carbody bounce");
  EXPECT_EQ(modes[1].name, "carbody pitch");
  EXPECT_EQ((std::set<std::string>{modes[2].name, modes[3].name}),
            (std::set<std::string>{"front_bogie + rear_bogie bounce in phase",
                                   "front_bogie + rear_bogie bounce in antiphase"}));
}

TEST(ModesOf, UndampedModesHaveNoRealPart) {
  const std::vector<Mode> modes =
      modesOf(coachMatrix({.secondary_damping = 0.0, .primary_damping = 0.0}), coachStates());
  ASSERT_EQ(modes.size(), 6u);
  for (const Mode& mode : modes) {
    EXPECT_EQ(mode.eigenvalue.real(), 0.0) << mode.name;
    EXPECT_EQ(mode.damping_ratio, 0.0) << mode.name;
  }
}

TEST(ModesOf, CriticallyDampedMassIsOneDoubleRootWithOneShape) {
  const double w = 7.0;
  const auto modes = modesOf(Eigen::Matrix2d{{0.0, 1.0}, {-w * w, -2 * w}}, statesOf({"carbody.z"}));
  ASSERT_EQ(modes.size(), 1u);
  EXPECT_EQ(modes[0].multiplicity, 2);
  // The two halves of a defective root split by sqrt(1e-16); their mean does not move.
  EXPECT_WITHIN(modes[0].eigenvalue.real(), -w, 1e-13);
  EXPECT_EQ(modes[0].eigenvalue.imag(), 0.0);
  EXPECT_WITHIN(modes[0].damping_ratio, 1.0, 1e-14);
  EXPECT_EQ(modes[0].name, "carbody bounce, aperiodic");
}

TEST(ModesOf, OverdampedMassHasTwoRealRoots) {
  // lambda^2 + 10 lambda + 9 = (lambda + 1)(lambda + 9)
  const auto modes = modesOf(Eigen::Matrix2d{{0.0, 1.0}, {-9.0, -10.0}}, statesOf({"carbody.z"}));
  ASSERT_EQ(modes.size(), 2u);
  EXPECT_WITHIN(modes[0].eigenvalue.real(), -1.0, 1e-14);
  EXPECT_WITHIN(modes[1].eigenvalue.real(), -9.0, 1e-13);
  EXPECT_EQ(modes[0].eigenvalue.imag(), 0.0);
  EXPECT_EQ(modes[1].damping_ratio, 1.0);
  EXPECT_EQ(modes[0].name, "carbody bounce, aperiodic");
  EXPECT_EQ(modes[1].name, "carbody bounce, aperiodic (2)");
}

TEST(ModesOf, UnstableRootHasNegativeDamping) {
  const auto modes = modesOf(Eigen::Matrix2d{{0.0, 1.0}, {-25.0, 1.0}}, statesOf({"carbody.z"}));
  ASSERT_EQ(modes.size(), 1u);
  EXPECT_WITHIN(modes[0].damping_ratio, -0.1, 1e-14);
}

TEST(ModesOf, FreeBodyHasADoubleZero) {
  // Two masses joined by a spring, held by nothing: free motion, and one mode at sqrt(2 k / m).
  const double m = 2.0, k = 50.0;
  const Eigen::Matrix2d K{{k, -k}, {-k, k}};
  const auto modes =
      modesOf(stateMatrix(m * Eigen::Matrix2d::Identity(), Eigen::Matrix2d::Zero(), K), statesOf({"a.z", "b.z"}));
  ASSERT_EQ(modes.size(), 2u);
  EXPECT_EQ(modes[0].eigenvalue, 0.0);
  EXPECT_EQ(modes[0].multiplicity, 2);
  EXPECT_EQ(modes[0].damping_ratio, 0.0);
  EXPECT_WITHIN(std::abs(modes[0].shape(0) - modes[0].shape(1)), 0.0, 1e-13);
  EXPECT_EQ(modes[0].name, "a + b bounce in phase, free");
  EXPECT_WITHIN(modes[1].eigenvalue.imag(), std::sqrt(2 * k / m), 1e-13);
}

TEST(ModesOf, StiffContactSpringsDoNotBlurTheSoftModes) {
  // A soft body (1 Hz) on a wheelset on its contact spring (200 Hz): the soft root to the perturbation of the wheel.
  const double m = 32e3, mw = 1.8e3, k = 1.2e6, kh = 2.4e9;
  const Eigen::Matrix2d K{{k, -k}, {-k, k + kh}}, M = Eigen::Vector2d(m, mw).asDiagonal();
  const auto modes = modesOf(stateMatrix(M, Eigen::Matrix2d::Zero(), K), statesOf({"carbody.z", "wheelset_1.z"}));
  // m mw w^4 - (m (k + kh) + mw k) w^2 + k kh = 0, the smaller root without cancellation.
  const double b = m * (k + kh) + mw * k, w2 = 2 * k * kh / (b + std::sqrt(b * b - 4 * m * mw * k * kh));
  ASSERT_EQ(modes.size(), 2u);
  EXPECT_WITHIN(modes[0].eigenvalue.imag(), std::sqrt(w2), 1e-16 * 4 * 1155 * 1155 / 6);  // |A|^2 eps / (2 w)
  EXPECT_EQ(modes[0].multiplicity, 1);
  EXPECT_EQ(modes[0].name, "carbody bounce");
  EXPECT_EQ(modes[1].name, "wheelset_1 bounce");
}

TEST(ModesOf, FourEqualWheelsetsAreNamedOneByOne) {
  const Eigen::MatrixXd I = Eigen::MatrixXd::Identity(4, 4);
  const auto modes = modesOf(stateMatrix(I, 0.1 * I, 100.0 * I), statesOf({"w1.z", "w2.z", "w3.z", "w4.z"}));
  ASSERT_EQ(modes.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(modes[i].multiplicity, 4);
    EXPECT_EQ(modes[i].name, "w" + std::to_string(i + 1) + " bounce");
  }
}

TEST(ModesOf, RefusesWhatIsNotAStateMatrix) {
  EXPECT_THROW((void)modesOf(Eigen::MatrixXd::Zero(2, 3), statesOf({"a.z"})), std::invalid_argument);
  EXPECT_THROW((void)modesOf(Eigen::MatrixXd::Zero(2, 2), statesOf({"a.z", "b.z"})), std::invalid_argument);
  EXPECT_THROW((void)modesOf(Eigen::MatrixXd::Constant(2, 2, std::nan("")), statesOf({"a.z"})), std::invalid_argument);
}

class Nonlinear : public System {
 public:
  [[nodiscard]] int channels() const override { return 1; }
  [[nodiscard]] StateLayout layout() const override { return {.coordinates = 1}; }
  [[nodiscard]] const std::vector<Channel>& states() const override { return states_; }
  [[nodiscard]] const std::vector<Channel>& outputs() const override { return states_; }
  void derivative(std::span<const double>, std::span<const double>, std::span<double>) const override {}
  void output(std::span<const double>, std::span<const double>, std::span<double>) const override {}

 private:
  std::vector<Channel> states_ = statesOf({"a.z"});
};

TEST(ModesOf, NonlinearSystemIsRefusedWithTheRemedy) {
  try {
    (void)modesOf(Nonlinear());
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "modes: the system is nonlinear (it has no matrices); linearise it about a state with "
                 "differencedStateSpace()");
  }
}

}  // namespace
}  // namespace vehicle::test
