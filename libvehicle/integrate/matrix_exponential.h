#pragma once

#include <Eigen/Core>

namespace vehicle {

/// e^A - I by scaling and squaring of the [13/13] Pade approximant.
///
/// The identity is never added: of a short step e^A is nearly I, and what a propagator adds to the state must not
/// lose its last digits to the ones on the diagonal. With e^(A/2^s) - I = (V - U)^-1 2 U, the squarings are
/// E <- E E + 2 E. Backward error below 2^-53 |A|_1; rounding grows with the squarings, so balance A first.
/// Source: N. J. Higham, SIAM J. Matrix Anal. Appl. 26 (2005) 1179-1193, algorithm 2.3.
/// @param A  (n x n)
/// @throws std::invalid_argument unless A is square and finite
[[nodiscard]] Eigen::MatrixXd expMinusIdentity(const Eigen::MatrixXd& A);

/// e^A = expMinusIdentity(A) + I.
[[nodiscard]] Eigen::MatrixXd matrixExponential(const Eigen::MatrixXd& A);

/// Diagonal of D, powers of two, such that row i and column i of D^-1 A D have about the same 1-norm for every i.
///
/// States of a vehicle have the size of their units (m beside m/s, rad): A of a wheel on its contact spring spans
/// eight decades, and the exponential is only as accurate as its largest entry. Powers of two scale without
/// rounding.
/// Source: E. E. Osborne, J. ACM 7 (1960) 338-345; B. N. Parlett, C. Reinsch, Numer. Math. 13 (1969) 293-304.
/// @param A  (n x n), finite
[[nodiscard]] Eigen::VectorXd balancingScales(const Eigen::MatrixXd& A);

}  // namespace vehicle
