#include "libvehicle/linear/steady_state.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>

#include "libvehicle/system/dense_solvers.h"

namespace vehicle {
namespace {

using Complex = std::complex<double>;

// Reciprocal condition number of a matrix that is singular but for rounding.
constexpr double kSingular = 1e-14;

// Velocities are larger than heights by a frequency; in these units a condition number means something.
double velocityScale(const Eigen::MatrixXd& A) {
  const Eigen::Index N = A.rows() / 2;
  const double stiffest = A.bottomLeftCorner(N, N).cwiseAbs().maxCoeff();
  return stiffest > 0.0 ? std::sqrt(stiffest) : 1.0;
}

void requireShape(const StateSpace& system) {
  if (system.A.rows() < 2 || system.A.rows() != system.A.cols() || system.A.rows() % 2 != 0 ||
      system.B.rows() != system.A.rows() || system.B.cols() % 2 != 0) {
    throw std::invalid_argument("steady state: A is " + std::to_string(system.A.rows()) + " x " +
                                std::to_string(system.A.cols()) + ", B " + std::to_string(system.B.rows()) + " x " +
                                std::to_string(system.B.cols()) + ", must be 2N x 2N and 2N x 2w");
  }
}

// Solves (i w - A) X = force in units where velocities are as large as heights; empty where it is singular.
bool solve(const Eigen::MatrixXd& A, double w, const Eigen::VectorXcd& force, Eigen::VectorXcd& X) {
  const Eigen::Index N = A.rows() / 2;
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(2 * N);
  scale.tail(N).setConstant(velocityScale(A));
  Eigen::MatrixXcd matrix = (-(scale.cwiseInverse().asDiagonal() * A * scale.asDiagonal())).cast<Complex>();
  matrix.diagonal().array() += Complex(0.0, w);
  const Eigen::PartialPivLU<Eigen::MatrixXcd> lu(matrix);
  // Not above, rather than below: a zero pivot gives NaN.
  if (!(lu.rcond() > kSingular)) return false;
  X = scale.asDiagonal() * lu.solve(scale.cwiseInverse().asDiagonal() * force);
  return true;
}

}  // namespace

Eigen::VectorXcd steadyAmplitude(const StateSpace& system, const InputSegment& segment, int frequency) {
  requireShape(system);
  const auto F = segment.angular_frequency.size();
  const Eigen::Index channels = system.B.cols() / 2;
  if (frequency < 0 || static_cast<std::size_t>(frequency) >= F) {
    throw std::invalid_argument("steady state: frequency number " + std::to_string(frequency) +
                                ", must be 0 or more and below " + std::to_string(F));
  }
  const auto f = static_cast<std::size_t>(frequency);
  const double w = segment.angular_frequency[f];
  Eigen::VectorXcd u(2 * channels);
  for (Eigen::Index j = 0; j < channels; ++j) {
    const std::size_t at = static_cast<std::size_t>(j) * F + f;
    u(j) = Complex(segment.cosine[at], -segment.sine[at]);
    u(channels + j) = Complex(0.0, w) * u(j);
  }
  Eigen::VectorXcd X;
  if (!solve(system.A, w, system.B.cast<Complex>() * u, X)) {
    std::ostringstream message;
    message << "steady state: the harmonic of " << w << " rad/s (" << w / (2.0 * std::numbers::pi)
            << " Hz) meets an undamped mode, so the motion grows for ever; damp that mode or change the speed";
    throw std::invalid_argument(message.str());
  }
  return X;
}

Eigen::VectorXd steadyState(const StateSpace& system, const InputSegment& segment, double t) {
  requireShape(system);
  requireClosedForm("steady state", "", segment);
  const Eigen::Index channels = system.B.cols() / 2;
  Eigen::VectorXcd constant = Eigen::VectorXcd::Zero(2 * channels);
  for (Eigen::Index j = 0; j < channels; ++j) {
    const double* p = segment.polynomial.data() + InputSegment::kPolynomial * j;
    constant(j) = p[0];
    for (int k = 1; k < InputSegment::kPolynomial; ++k) {
      if (p[k] == 0.0) continue;
      throw std::invalid_argument("steady state: the height of channel " + std::to_string(j) + " holds a term s^" +
                                  std::to_string(k) + ", which never repeats itself; only a constant and harmonics do");
    }
  }
  Eigen::VectorXd x = Eigen::VectorXd::Zero(system.A.rows());
  const Eigen::VectorXcd force = system.B.cast<Complex>() * constant;
  if (!force.isZero(0.0)) {
    Eigen::VectorXcd X;
    if (!solve(system.A, 0.0, force, X)) {
      throw std::invalid_argument(
          "steady state: a constant height has no rest position, because a motion has no stiffness; carry every body "
          "by springs");
    }
    x += X.real();
  }
  for (std::size_t f = 0; f < segment.angular_frequency.size(); ++f) {
    const double phase = segment.angular_frequency[f] * (t - segment.begin);
    x += (steadyAmplitude(system, segment, static_cast<int>(f)) * std::polar(1.0, phase)).real();
  }
  return x;
}

}  // namespace vehicle
