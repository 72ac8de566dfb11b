#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "libvehicle/system/system.h"

namespace vehicle {

/// What a small disturbance of a linear vehicle can do to the columns of its result: the one mechanism from
/// which the tolerance ledger derives its sizes.
///
/// Let y = C x + D u + y0 and let x' = A x + B u + d(t) with |d_j(t)| <= e_j. Then for every column i
///
///     max_t |y_i - y_i(d=0)| <= sum_j L_ij e_j,        L = int_0^T |C exp(A s)| ds
///
/// (the largest output a bounded disturbance can bring about: the 1-norm of the impulse response, reached by the
/// worst sign pattern). Source: J. C. Doyle, B. A. Francis, A. R. Tannenbaum, Feedback Control Theory, sec. 2.2.
struct Sensitivity {
  StateSpace matrices;            // A (n x n), B (n x 2 w)
  Eigen::MatrixXd C;              // (outputs x n)   what a state does to a column
  Eigen::MatrixXd D;              // (outputs x 3 w) what heights, rates, accelerations do
  Eigen::VectorXd static_output;  // (outputs) columns at rest: the static loads
  Eigen::MatrixXd L;              // (outputs x n) [s]
  double fastest = 0.0;           // [1/s] max |lambda(A)|
  double slowest_decay = 0.0;     // [1/s] min -Re lambda(A); negative if unstable
};

/// @param system    linear
/// @param duration  T [s], > 0
/// @throws std::invalid_argument if the system has no matrices or duration is not > 0
[[nodiscard]] Sensitivity sensitivityOf(const System& system, double duration);

}  // namespace vehicle
