#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "libvehicle/system/input.h"
#include "libvehicle/system/system.h"

namespace vehicle {

/// Columns of a linear system and their derivatives in time at one instant, exactly: with x' = A x + B (eta, eta') and
/// y = C x + D (eta, eta', eta'') + y0,
///
///     x^(k+1) = A x^(k) + B (eta^(k), eta^(k+1)),     y^(k) = C x^(k) + D (eta^(k), eta^(k+1), eta^(k+2))
///
/// and the rail's own derivatives in closed form. Keeps workspace: one object a thread.
class ColumnDerivatives {
 public:
  /// @throws std::invalid_argument  if the system has no matrices
  explicit ColumnDerivatives(const System& system);

  /// @param t  [s]   @param x  (n)   @param order  highest derivative, >= 0
  /// @return (columns x (order + 1)) in the columns' units per s^k; valid until the next call
  const Eigen::MatrixXd& at(const InputSegment& segment, double t, std::span<const double> x, int order);

 private:
  void fillRail(const InputSegment& segment, double t, int order);

  StateSpace matrices_;
  Eigen::MatrixXd C_;        // (columns x n)
  Eigen::MatrixXd D_;        // (columns x 3 w)
  Eigen::VectorXd at_rest_;  // (columns) y0
  Eigen::Index channels_;
  Eigen::MatrixXd rail_;  // (w x (order + 3)) derivatives of eta
  Eigen::VectorXd x_, next_, u_;
  Eigen::MatrixXd y_;
};

}  // namespace vehicle
