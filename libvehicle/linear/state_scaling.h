#pragma once

#include <cmath>

#include <Eigen/Core>

namespace vehicle {

/// Units of the state (q, q') in which velocities are as large as displacements: q' is counted in a frequency, that of
/// the stiffest spring, rounded to a power of two so that scaling changes no digit. The norm of the scaled A is that
/// frequency, and the rounding of an eigenvalue solver is relative to it. Private to this room.
/// @param A  (2N x 2N)   @return (2N)
[[nodiscard]] inline Eigen::VectorXd stateUnits(const Eigen::MatrixXd& A) {
  const Eigen::Index N = A.rows() / 2;
  const double stiffest = A.bottomLeftCorner(N, N).cwiseAbs().maxCoeff();
  Eigen::VectorXd units = Eigen::VectorXd::Ones(2 * N);
  if (stiffest > 0.0) units.tail(N).setConstant(std::exp2(std::round(0.5 * std::log2(stiffest))));
  return units;
}

/// A of the state counted in these units.
[[nodiscard]] inline Eigen::MatrixXd inUnits(const Eigen::MatrixXd& A, const Eigen::VectorXd& units) {
  return units.cwiseInverse().asDiagonal() * A * units.asDiagonal();
}

}  // namespace vehicle
