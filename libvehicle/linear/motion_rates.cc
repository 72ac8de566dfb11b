#include "libvehicle/linear/motion_rates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "libvehicle/system/dense_solvers.h"

namespace vehicle {
namespace {

using Complex = std::complex<double>;

/// What an eigenvalue may owe to rounding, as a share of the matrix's norm.
constexpr double kRounding = 1e-11;

/// max |lambda| of x' = f(x): the growth of |f^k x| over an even number of applications, so that neither the units of the
/// rates nor the turning of a conjugate pair shows.
double spectralRadius(const System& system) {
  const auto n = static_cast<std::size_t>(system.size());
  std::vector<double> u(2 * static_cast<std::size_t>(system.channels()), 0.0);
  std::vector<double> x(n), next(n), at_rest(n);
  const std::vector<double> zero(n, 0.0);
  system.derivative(zero, u, at_rest);
  for (std::size_t i = 0; i < n; ++i) x[i] = std::cos(static_cast<double>(3 * i + 1));  // part of every mode
  const auto apply = [&](int times) {
    double logarithm = 0.0;
    for (int k = 0; k < times; ++k) {
      system.derivative(x, u, next);
      double square = 0.0;
      for (std::size_t i = 0; i < n; ++i) {
        next[i] -= at_rest[i];
        square += next[i] * next[i];
      }
      const double norm = std::sqrt(square);
      if (!(norm > 0.0) || !std::isfinite(norm)) return -std::numeric_limits<double>::infinity();
      for (double& each : next) each /= norm;
      logarithm += std::log(norm);
      x.swap(next);
    }
    return logarithm;
  };
  constexpr int kSettle = 40;
  constexpr int kMeasured = 40;
  if (!std::isfinite(apply(kSettle))) return 0.0;
  const double grown = apply(kMeasured);
  return std::isfinite(grown) ? std::exp(grown / kMeasured) : 0.0;
}

}  // namespace

MotionRates::MotionRates(const System& system) {
  if (system.size() <= kMostStates) {
    const std::optional<StateSpace> matrices = system.linear();
    if (!matrices) throw std::invalid_argument("motion rates: the system is nonlinear, it has no matrices");
    setFrom(matrices->A);
  } else {
    fastest_ = spectralRadius(system);
  }
}

MotionRates::MotionRates(const Eigen::MatrixXd& A) { setFrom(A); }

void MotionRates::setFrom(const Eigen::MatrixXd& A) {
  // Rates in units of a frequency times q, as modesOf() has them.
  const Eigen::Index N = A.rows() / 2;
  const double stiffest = N > 0 ? A.bottomLeftCorner(N, N).cwiseAbs().maxCoeff() : 0.0;
  Eigen::VectorXd units = Eigen::VectorXd::Ones(A.rows());
  if (stiffest > 0.0) units.tail(N).setConstant(std::exp2(std::round(0.5 * std::log2(stiffest))));
  const Eigen::MatrixXd scaled = units.cwiseInverse().asDiagonal() * A * units.asDiagonal();
  norm_ = scaled.norm();
  const Eigen::VectorXcd values = scaled.eigenvalues();
  eigenvalues_.assign(values.begin(), values.end());
  for (const Complex& each : eigenvalues_) fastest_ = std::max(fastest_, std::abs(each));
  // M^-1 K has real eigenvalues; damping, however large, does not blur them.
  const Eigen::VectorXcd squared = (-A.bottomLeftCorner(N, N)).eval().eigenvalues();
  const double zero = kRounding * squared.cwiseAbs().maxCoeff();
  for (const Complex& each : squared) {
    if (std::abs(each) <= zero) continue;
    const double frequency = std::sqrt(std::abs(each));
    slowest_ = slowest_ > 0.0 ? std::min(slowest_, frequency) : frequency;
    stiffest_ = std::max(stiffest_, frequency);
  }
}

double MotionRates::fastestToShow() const {
  return stiffest_ > 0.0 ? std::min(fastest_, kDecays * stiffest_) : fastest_;
}

double MotionRates::growth() const {
  double most = 0.0;
  for (const Complex& each : eigenvalues_) most = std::max(most, each.real());
  return most > kRounding * norm_ ? most : 0.0;
}

double MotionRates::resolvingRk4Step(double duration) const {
  constexpr double kLargestLoss = 0.05;
  const auto stepFor = [&](double remembered, double rate) {
    // remembered / h |h lambda|^5 / 120 = kLargestLoss; a motion without stiffness (lambda = 0) asks for nothing.
    return std::pow(120.0 * kLargestLoss / (remembered * std::pow(rate, 5)), 0.25);
  };
  if (eigenvalues_.empty()) return fastest_ > 0.0 ? stepFor(duration, fastest_) : HUGE_VAL;
  double step = std::numeric_limits<double>::infinity();
  for (const Complex& lambda : eigenvalues_) {
    const double remembered = -lambda.real() * duration > 1.0 ? -1.0 / lambda.real() : duration;
    step = std::min(step, stepFor(remembered, std::abs(lambda)));
  }
  return step;
}

bool MotionRates::rk4Grows(double step) const {
  // Along the imaginary axis the method is stable to 2.828, along the real one to 2.785.
  if (eigenvalues_.empty()) return step * fastest_ > 2.785;
  return std::any_of(eigenvalues_.begin(), eigenvalues_.end(), [&](const Complex& lambda) {
    if (lambda.real() > kRounding * norm_) return false;
    const Complex z = step * lambda;
    const Complex r = 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)));
    return std::abs(r) > 1.0 + 1e-9;
  });
}

}  // namespace vehicle
