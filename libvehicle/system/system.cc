#include "libvehicle/system/system.h"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace vehicle {

void requireDense(const char* who, int states) {
  if (states <= kMostDenseStates) return;
  throw std::invalid_argument("the form " + std::string(who) + " has " + std::to_string(states) +
                              " states here, and its matrices are formed for at most " +
                              std::to_string(kMostDenseStates) + "; take the method rk4 or dopri5, which need none");
}

StateSpace differencedStateSpace(const System& system, std::span<const double> x0, std::span<const double> u0,
                                 double scale) {
  const int n = system.size();
  const int inputs = 2 * system.channels();
  if (static_cast<int>(x0.size()) != n || static_cast<int>(u0.size()) != inputs || !(scale > 0.0) ||
      !std::isfinite(scale)) {
    std::ostringstream message;
    message << "differencedStateSpace: x0 has " << x0.size() << " values (must be " << n << "), u0 " << u0.size()
            << " (must be " << inputs << "), scale = " << scale << " (must be finite and > 0)";
    throw std::invalid_argument(message.str());
  }
  std::vector<double> x(x0.begin(), x0.end());
  std::vector<double> u(u0.begin(), u0.end());
  Eigen::VectorXd above(n);
  Eigen::VectorXd below(n);
  const auto column = [&](double& variable) -> Eigen::VectorXd {
    const double value = variable;
    const double high = value + scale;
    const double low = value - scale;
    variable = high;
    system.derivative(x, u, {above.data(), static_cast<std::size_t>(n)});
    variable = low;
    system.derivative(x, u, {below.data(), static_cast<std::size_t>(n)});
    variable = value;
    // The distance really taken: beside a large value, 2 scale is rounded away in part.
    return (above - below) / (high - low);
  };
  StateSpace result{Eigen::MatrixXd(n, n), Eigen::MatrixXd(n, inputs)};
  for (int j = 0; j < n; ++j) result.A.col(j) = column(x[static_cast<std::size_t>(j)]);
  for (int j = 0; j < inputs; ++j) result.B.col(j) = column(u[static_cast<std::size_t>(j)]);
  return result;
}

}  // namespace vehicle
