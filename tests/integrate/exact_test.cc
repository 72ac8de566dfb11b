#include "libvehicle/integrate/exact.h"

#include <cmath>
#include <stdexcept>

#include "tests/integrate/cases.h"
#include "tests/support/tolerance.h"

namespace vehicle::test {
namespace {

const Observer kIgnore = [](int, int, double, std::span<const double>) { return true; };

double errorOf(const Case& problem, double output_step = 0.01, Statistics* statistics = nullptr) {
  return worstError(problem, output_step,
                    [&](const System& s, const Input& i, const Schedule& g, const auto& x, const auto& o) {
                      const Statistics cost = runExact({s, i, g, x}, o);
                      if (statistics != nullptr) *statistics = cost;
                      return cost;
                    });
}

std::vector<RailPiece> manyWaves(int count, double first, double end) {
  RailPiece piece{0.0, end, 0.001, 0.002, {}};
  for (int f = 0; f < count; ++f) {
    piece.waves.push_back({first + 1.7 * f, std::polar(1e-3 / (1 + f), 0.9 * f)});
  }
  return {piece};
}

TEST(Exact, AnyStepGivesTheSameMotion) {
  const Case problem = caseOf("sine", bounce(), sineRail(), {0.002, 0.01});
  for (const double step : {3e-4, 7e-3, 0.1, 1.5}) EXPECT_WITHIN(errorOf(problem, step), 0.0, 1e-13) << step;
}

// Up to ten frequencies in one augmented exponential, beyond through particular solutions: both are the closed form.
TEST(Exact, ManyHarmonicsGoThroughTheParticularSolutionAndStayExact) {
  for (const int count : {9, 10, 11, 60}) {
    EXPECT_WITHIN(errorOf(caseOf("waves", bounce(), manyWaves(count, 0.4, 3.0), {0.002, 0.0})), 0.0, 1e-13) << count;
  }
}

// m z'' + k z = k a sin(w s) with w = sqrt(k/m) from rest: z = a/2 (sin w s - w s cos w s).
// Source: e.g. Magnus, Popp, Schwingungen, 7th ed., sec. 4.1.
TEST(Exact, UndampedResonanceGrowsAsItShould) {
  const double w = 8.0, a = 0.003;
  for (const int others : {0, 11}) {
    DrivenMass mass{1.0, 0.0, w * w, 0.0, w * w};
    RailPiece rail{0.0, 10.0, 0.0, 0.0, {{w, {0.0, -a}}}};
    for (int f = 0; f < others; ++f) rail.waves.push_back({20.0 + f, 0.0});
    const Case problem = caseOf("resonance", mass, {rail});
    double worst = 0.0;
    runExact({problem.system, problem.input, Schedule(problem.input, 0.01), problem.start},
             [&](int, int, double t, std::span<const double> x) {
               worst = std::max(worst, std::abs(x[0] - 0.5 * a * (std::sin(w * t) - w * t * std::cos(w * t))));
               return true;
             });
    // Peak 0.12 m; 80 radians of phase round at 1e-14.
    EXPECT_WITHIN(worst, 0.0, 1e-13 * 0.5 * a * w * 10.0) << others;
  }
}

TEST(Exact, StiffContactSpringUnderASoftMassStaysExact) {
  // The joint is a wheel's contact: w = 1448 rad/s beside 17 rad/s, A spans seven decades. Multiples of the mass
  // 2^11 kg, so that A holds k + kc without rounding: its last bit would be 4e-13 of k.
  const TwoMasses two{2048.0, 8192.0, 6e5, 16384.0, 2147483648.0};
  const std::vector<RailPiece> leading = {{0.0, 2.0, 0.0, 0.0, {{9.0, {0.0, -0.005}}}}};
  const std::vector<RailPiece> trailing = {{0.0, 2.0, 0.0, 0.0, {{9.0, std::polar(-0.002, 1.0)}}}};
  std::vector<RailPiece> mean = leading, difference = leading;
  mean[0].waves[0].amplitude = 0.5 * (leading[0].waves[0].amplitude + trailing[0].waves[0].amplitude);
  difference[0].waves[0].amplitude = 0.5 * (leading[0].waves[0].amplitude - trailing[0].waves[0].amplitude);
  const MatrixSystem system(matricesOf(two));
  const Input input = inputOf({leading, trailing});
  double worst = 0.0;
  runExact({system, input, Schedule(input, 5e-3), std::vector<double>(4, 0.0)},
           [&](int, int, double t, std::span<const double> x) {
             const MassState p = two.mean().at({}, mean, t), d = two.difference().at({}, difference, t);
             worst = std::max(worst, std::abs(x[0] - p.z - d.z));
             worst = std::max(worst, std::abs(x[1] - p.z + d.z));
             return true;
           });
  // Peak 5 mm. |A h| = 16 balanced: two squarings; 400 steps.
  EXPECT_WITHIN(worst, 0.0, 1e-13 * 5e-3);
}

// A height known at samples, Hermite held: a sine's samples give the sine within the hold's own h^4 / 384 w^4, and
// one propagator serves all 3000 segments.
TEST(Exact, StoredSamplesShareOnePropagator) {
  const double dt = 1e-3, w = 9.0, a = 5e-3;
  std::vector<double> height, rate;
  for (int i = 0; i <= 3000; ++i) {
    height.push_back(a * std::sin(w * i * dt));
    rate.push_back(a * w * std::cos(w * i * dt));
  }
  Case problem = caseOf("stored", bounce(), {{0.0, 3.0, 0.0, 0.0, {{w, {0.0, -a}}}}});
  problem.input = storedInput(1, 0.0, dt, height, rate);
  Statistics statistics;
  // (w h)^4 / 384 = 2e-11 of the rail, and as much of its rate again.
  EXPECT_WITHIN(errorOf(problem, 0.01, &statistics), 0.0, 1e-10);
  EXPECT_EQ(statistics.steps, 3000);
  EXPECT_LE(statistics.evaluations, 2);  // one with the state, one with the polynomials
}

// Against one segment of the same cubic: no hold error, only the cut into 3000 and the clock's rounding.
TEST(Exact, CutIntoStoredSamplesLosesNothing) {
  const double dt = 1e-3, begin = 100.0;
  const auto cubic = [](double s) { return s * (0.02 - s * (0.015 - s * 0.003)); };
  const auto slope = [](double s) { return 0.02 - s * (0.03 - s * 0.009); };
  std::vector<double> height, rate;
  for (int i = 0; i <= 3000; ++i) {
    height.push_back(cubic(i * dt));
    rate.push_back(slope(i * dt));
  }
  const Case problem = caseOf("cubic", bounce(), flatRail());
  InputSegment whole;
  whole.begin = begin;
  whole.end = begin + 3.0;
  whole.polynomial = {0.0, 0.02, -0.015, 0.003};
  const Input once(1, {whole});
  const Input stored = storedInput(1, begin, dt, height, rate);
  std::vector<double> expected;
  runExact({problem.system, once, Schedule(once, 0.01), problem.start},
           [&](int, int, double, std::span<const double> x) {
             expected.insert(expected.end(), x.begin(), x.end());
             return true;
           });
  std::size_t at = 0;
  double worst = 0.0;
  runExact({problem.system, stored, Schedule(stored, 0.01), problem.start},
           [&](int, int, double, std::span<const double> x) {
             for (const double value : x) worst = std::max(worst, std::abs(value - expected[at++]));
             return true;
           });
  EXPECT_EQ(at, expected.size());
  // Heights of 10 mm round at 1e-18, differences over 1 ms divide that by h^2: 1e-12 of the acceleration, at random;
  // instants near 100 s round at 1.4e-14 s. Uncorrected, 1e-11 relative in each step's length would add up to 1e-11.
  EXPECT_WITHIN(worst, 0.0, 2e-14);
}

TEST(Exact, RefusesANonlinearSystem) {
  const ExpressionSystem system(2, 1, [](const double*, const double*, double*) {});
  const Input input = inputOf({flatRail()});
  try {
    runExact({system, input, Schedule(input, 0.01), std::vector<double>(2, 0.0)}, kIgnore);
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "exact: the system is nonlinear (it has no matrices A, B); exact propagation needs a linear one, take "
                 "rk4 or dopri5");
  }
}

// The size known to the compiler against the general loop: another order of the sums, so near, not equal.
TEST(ExactPropagator, FixedSizeKernelGivesTheGeneralKernelsMotion) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(8, 8);
  for (int i = 0; i < 4; ++i) {
    A(i, i + 4) = 1.0;
    for (int j = 0; j < 4; ++j) A(i + 4, j) = (i == j ? -900.0 : 120.0 * std::cos(i + 2.0 * j));
    A(i + 4, i + 4) = -3.0;
  }
  Eigen::MatrixXd forcing(8, 4);
  for (Eigen::Index i = 0; i < 8; ++i) {
    for (Eigen::Index j = 0; j < 4; ++j) forcing(i, j) = i < 4 ? 0.0 : std::sin(1.0 + static_cast<double>(i + 5 * j));
  }
  ExactPropagator fixed(A, forcing, {5.0, 15.0}, 5e-3);
  // A ninth state that nothing drives makes the size unknown to the compiler.
  Eigen::MatrixXd larger = Eigen::MatrixXd::Zero(9, 9);
  larger.topLeftCorner(8, 8) = A;
  larger(8, 8) = -1.0;
  Eigen::MatrixXd larger_forcing = Eigen::MatrixXd::Zero(9, 4);
  larger_forcing.topRows(8) = forcing;
  ExactPropagator general(larger, larger_forcing, {5.0, 15.0}, 5e-3);
  double x[8] = {}, y[9] = {}, o[4], p[4], peak = 0.0, worst = 0.0;
  fixed.seed(0.0, o);
  general.seed(0.0, p);
  for (int k = 0; k < 64; ++k) {
    fixed.propagate(x, o);
    general.propagate(y, p);
    for (int i = 0; i < 8; ++i) {
      peak = std::max(peak, std::abs(y[i]));
      worst = std::max(worst, std::abs(x[i] - y[i]));
    }
  }
  EXPECT_GT(peak, 1e-3);
  EXPECT_WITHIN(worst, 0.0, 1e-14 * peak);  // 64 steps of a few roundings
  EXPECT_EQ(y[8], 0.0);
  double seeded[4];
  fixed.seed(64 * 5e-3, seeded);
  for (int i = 0; i < 4; ++i) EXPECT_WITHIN(o[i], seeded[i], 1e-14);  // 64 rotations
}

TEST(ExactPropagator, RefusesShapesAndLengthsThatDoNotFit) {
  const Eigen::MatrixXd A = Eigen::MatrixXd::Identity(2, 2);
  EXPECT_THROW(ExactPropagator(A, Eigen::MatrixXd(2, 0), {}, 0.0), std::invalid_argument);
  EXPECT_THROW(ExactPropagator(A, Eigen::MatrixXd(2, 0), {}, std::nan("")), std::invalid_argument);
  EXPECT_THROW(ExactPropagator(A, Eigen::MatrixXd::Zero(2, 3), {1.0}, 0.1), std::invalid_argument);
  EXPECT_THROW(ExactPropagator(Eigen::MatrixXd::Zero(2, 3), Eigen::MatrixXd(2, 0), {}, 0.1), std::invalid_argument);
}

}  // namespace
}  // namespace vehicle::test
