#include "libvehicle/linear/steady_state.h"

#include <cmath>
#include <complex>
#include <stdexcept>
#include <string>

#include "tests/support/paper_matrices.h"
#include "tests/support/source_tree.h"
#include "tests/support/table.h"
#include "tests/support/tolerance.h"
#include "tests/support/truths.h"

namespace vehicle::test {
namespace {

using Complex = std::complex<double>;

StateSpace oneMass(const DrivenMass& mass) {
  StateSpace matrices{Eigen::Matrix2d{{0.0, 1.0}, {-mass.stiffness / mass.mass, -mass.damping / mass.mass}},
                      Eigen::Matrix2d::Zero()};
  matrices.B.row(1) << mass.rail_stiffness / mass.mass, mass.rail_damping / mass.mass;
  return matrices;
}

InputSegment segmentOf(const RailPiece& rail) {
  InputSegment segment;
  segment.begin = rail.begin;
  segment.end = rail.end;
  segment.polynomial = {rail.offset, rail.slope, 0.0, 0.0};
  for (const RailPiece::Wave& wave : rail.waves) {
    segment.angular_frequency.push_back(wave.angular_frequency);
    segment.cosine.push_back(wave.amplitude.real());
    segment.sine.push_back(-wave.amplitude.imag());
  }
  return segment;
}

const DrivenMass kMass{30e3, 75e3, 2e6, 75e3, 2e6};

TEST(SteadyState, OfAMassIsTheParticularSolution) {
  const RailPiece rail{2.0, 5.0, 0.004, 0.0, {{5.0, {0.003, -0.004}}, {15.0, {0.0, -0.002}}}};
  for (const double t : {2.0, 2.7, 4.9}) {
    const Eigen::VectorXd x = steadyState(oneMass(kMass), segmentOf(rail), t);
    const MassState truth = kMass.particular(rail, t - 2.0);
    EXPECT_WITHIN(x(0), truth.z, 1e-16 * 20);  // roundings of numbers near 10 mm, and 0.1 m/s
    EXPECT_WITHIN(x(1), truth.v, 1e-15 * 20);
  }
}

// A run that starts in its steady state stays in it: the free motion has no part.
TEST(SteadyState, SatisfiesTheEquationOfMotion) {
  const StateSpace paper = paperMatrices();
  const InputSegment segment = paperSegment(0.0, 10.0, 4);
  const Input input(4, {segment});
  Eigen::VectorXd u(8);
  for (const double t : {0.0, 1.3, 7.7}) {
    input.evaluate(0, t, {u.data(), 8});
    const double d = 1e-4;
    const Eigen::VectorXd slope = (steadyState(paper, segment, t + d) - steadyState(paper, segment, t - d)) / (2 * d);
    const Eigen::VectorXd expected = paper.A * steadyState(paper, segment, t) + paper.B * u;
    // Central difference: (w d)^2 / 6 = 4e-7 of slopes up to 0.4.
    for (Eigen::Index i = 0; i < 8; ++i) EXPECT_WITHIN(slope(i), expected(i), 2e-7) << t << ", " << i;
  }
}

// The certified sweep 20..150 km/h: x = Im(amplitude e^(i (h w t + phase))), so amplitude e^(i phase) = i conj-free X:
// Re[X e^(iwt)] = Im[i X e^(iwt)].
TEST(SteadyState, PaperSweepAgreesInAmplitudeAndPhase) {
  const auto table = readTable(sourcePath("tests/paper/data/sweep_consistent_J70t.csv"));
  const char* columns[4] = {"zk", "phik", "z1", "z2"};
  const StateSpace paper = paperMatrices();
  ASSERT_GT(table.at("V_mps").size(), 20u);
  for (std::size_t row = 0; row < table.at("V_mps").size(); ++row) {
    const InputSegment segment = paperSegment(0.0, 10.0, 4, table.at("V_mps")[row]);
    const Eigen::VectorXcd X = steadyAmplitude(paper, segment, table.at("harmonic")[row] == 1.0 ? 0 : 1);
    const double w = table.at("w_rad_s")[row];
    for (int i = 0; i < 4; ++i) {
      const std::string name = columns[i];
      const Complex expected = std::polar(table.at(name + "_amp")[row], table.at(name + "_phase_rad")[row]);
      const Complex acceleration =
          std::polar(table.at("dd" + name + "_amp")[row], table.at("dd" + name + "_phase_rad")[row]);
      // 1e-12 of the amplitude: rounding of a solve with condition number 1e3.
      const double error = std::abs(Complex(0.0, 1.0) * X(i) - expected) / std::abs(expected);
      EXPECT_WITHIN(error, 0.0, 1e-12) << name << " at " << table.at("V_kmh")[row] << " km/h";
      const double error_dd =
          std::abs(Complex(0.0, 1.0) * Complex(0.0, w) * X(i + 4) - acceleration) / std::abs(acceleration);
      EXPECT_WITHIN(error_dd, 0.0, 1e-12) << name << " at " << table.at("V_kmh")[row] << " km/h";
    }
  }
}

std::string messageOf(const StateSpace& system, const InputSegment& segment) {
  try {
    (void)steadyState(system, segment, 0.0);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

TEST(SteadyState, UndampedModeInResonanceIsRefused) {
  const DrivenMass undamped{2.0, 0.0, 128.0, 0.0, 128.0};
  EXPECT_EQ(messageOf(oneMass(undamped), segmentOf({0.0, 1.0, 0.0, 0.0, {{8.0, 0.001}}})),
            "steady state: the harmonic of 8 rad/s (1.27324 Hz) meets an undamped mode, so the motion grows for ever; "
            "damp that mode or change the speed");
  // Beside the resonance, and with the least damping, there is one.
  EXPECT_EQ(messageOf(oneMass(undamped), segmentOf({0.0, 1.0, 0.0, 0.0, {{8.001, 0.001}}})), "no error");
  EXPECT_EQ(messageOf(oneMass({2.0, 1e-6, 128.0, 0.0, 128.0}), segmentOf({0.0, 1.0, 0.0, 0.0, {{8.0, 0.001}}})),
            "no error");
}

TEST(SteadyState, RampIsRefused) {
  EXPECT_EQ(messageOf(oneMass(kMass), segmentOf({0.0, 1.0, 0.0, 0.01, {}})),
            "steady state: the height of channel 0 holds a term s^1, which never repeats itself; only a constant and "
            "harmonics do");
}

TEST(SteadyState, ConstantHeightUnderAMotionWithoutStiffnessIsRefused) {
  const StateSpace free{Eigen::Matrix2d{{0.0, 1.0}, {0.0, -0.5}}, Eigen::Matrix2d{{0.0, 0.0}, {1.0, 0.0}}};
  EXPECT_EQ(messageOf(free, segmentOf({0.0, 1.0, 0.01, 0.0, {}})),
            "steady state: a constant height has no rest position, because a motion has no stiffness; carry every body "
            "by springs");
  EXPECT_EQ(messageOf(free, segmentOf({0.0, 1.0, 0.0, 0.0, {}})), "no error");
}

TEST(SteadyAmplitude, RefusesAFrequencyThatDoesNotExist) {
  const InputSegment segment = paperSegment(0.0, 1.0, 4);
  EXPECT_THROW((void)steadyAmplitude(paperMatrices(), segment, 2), std::invalid_argument);
  EXPECT_THROW((void)steadyAmplitude(paperMatrices(), segment, -1), std::invalid_argument);
}

}  // namespace
}  // namespace vehicle::test
