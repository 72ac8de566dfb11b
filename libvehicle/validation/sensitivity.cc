#include "libvehicle/validation/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <unsupported/Eigen/MatrixFunctions>

#include "libvehicle/system/dense_solvers.h"

namespace vehicle {
namespace {

std::span<double> spanOf(Eigen::VectorXd& vector) { return {vector.data(), static_cast<std::size_t>(vector.size())}; }

/// C and D column by column: the outputs of a linear system are affine in state and input.
void probeOutputs(const System& system, Sensitivity& made) {
  const Eigen::Index outputs = static_cast<Eigen::Index>(system.outputs().size());
  Eigen::VectorXd x = Eigen::VectorXd::Zero(system.size());
  Eigen::VectorXd u = Eigen::VectorXd::Zero(3 * system.channels());
  Eigen::VectorXd y(outputs);
  made.static_output.resize(outputs);
  made.C.resize(outputs, x.size());
  made.D.resize(outputs, u.size());
  system.output(spanOf(x), spanOf(u), spanOf(made.static_output));
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    x(j) = 1.0;
    system.output(spanOf(x), spanOf(u), spanOf(y));
    made.C.col(j) = y - made.static_output;
    x(j) = 0.0;
  }
  for (Eigen::Index j = 0; j < u.size(); ++j) {
    u(j) = 1.0;
    system.output(spanOf(x), spanOf(u), spanOf(y));
    made.D.col(j) = y - made.static_output;
    u(j) = 0.0;
  }
}

/// int_0^T |C exp(A s)| ds by the trapezoidal rule, fine enough for the fastest mode unless that would take more
/// than kMostSteps; a mode that has died out between two nodes then counts with half an interval: too much, never
/// too little.
Eigen::MatrixXd impulseSize(const Sensitivity& made, double duration) {
  constexpr double kMostSteps = 20'000.0;
  constexpr double kRadiansPerStep = 0.2;
  // exp(-14) = 1e-6: what comes later adds nothing that matters to a bound.
  constexpr double kMemories = 14.0;
  double horizon = duration;
  if (made.slowest_decay > 0.0) horizon = std::min(horizon, kMemories / made.slowest_decay);
  const double steps = std::clamp(std::ceil(horizon * made.fastest / kRadiansPerStep), 200.0, kMostSteps);
  const double h = horizon / steps;
  const Eigen::MatrixXd advance = (made.matrices.A * h).exp();
  Eigen::MatrixXd impulse = made.C;
  Eigen::MatrixXd sum = 0.5 * impulse.cwiseAbs();
  const int count = static_cast<int>(steps);
  for (int i = 1; i <= count; ++i) {
    impulse = impulse * advance;
    sum += (i == count ? 0.5 : 1.0) * impulse.cwiseAbs();
  }
  return h * sum;
}

}  // namespace

Sensitivity sensitivityOf(const System& system, double duration) {
  if (!(duration > 0.0))
    throw std::invalid_argument(fmt::format("sensitivityOf: duration = {} s, must be > 0", duration));
  std::optional<StateSpace> matrices = system.linear();
  if (!matrices) throw std::invalid_argument("sensitivityOf: the system must be linear");
  Sensitivity made;
  made.matrices = std::move(*matrices);
  probeOutputs(system, made);
  const Eigen::VectorXcd eigenvalues = made.matrices.A.eigenvalues();
  made.fastest = eigenvalues.cwiseAbs().maxCoeff();
  made.slowest_decay = (-eigenvalues.real()).minCoeff();
  made.L = impulseSize(made, duration);
  return made;
}

}  // namespace vehicle
