#pragma once

#include <complex>
#include <vector>

#include <Eigen/Core>

namespace vehicle {

/// Eigenvalues of a real matrix that belong together, and their invariant subspace: a conjugate pair, a real root, or
/// several of them that coincide. Closed under conjugation, so the projector right * left is real. Unlike single
/// eigenvectors it stays well conditioned where a pair becomes two real roots. Private to this room.
struct RootGroup {
  std::complex<double> value;  // of a pair the one with Im >= 0; the mean of several
  Eigen::MatrixXcd right;      // (n x m) basis
  Eigen::MatrixXcd left;       // (m x n), left * right = 1
  [[nodiscard]] Eigen::Index size() const { return right.cols(); }
  /// Whether conjugate roots are apart.
  [[nodiscard]] bool isComplex() const;
};

/// Roots closer than this, relative to their size, coincide: no shape is asked which is which.
inline constexpr double kSameRoot = 1e-6;

inline bool RootGroup::isComplex() const { return 2.0 * value.imag() > kSameRoot * std::abs(value); }

/// All of them, in the order of |value|, then of Re.
///
/// One Schur decomposition; the basis of each group by moving its roots to the front of the triangle, the dual
/// one by moving them to its end.
/// Source: G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed., 7.6.2 (swapping by rotations).
/// @param A  (n x n), finite
/// @throws std::runtime_error if the iteration does not converge
[[nodiscard]] std::vector<RootGroup> rootGroupsOf(const Eigen::MatrixXd& A);

}  // namespace vehicle
