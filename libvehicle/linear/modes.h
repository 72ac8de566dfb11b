#pragma once

#include <complex>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "libvehicle/system/system.h"

namespace vehicle {

/// One mode of x' = A x.
struct Mode {
  std::complex<double> eigenvalue;  // [1/s]; of a conjugate pair the one with positive imaginary part
  double frequency = 0.0;           // [Hz] undamped, |lambda| / 2 pi; of a real root too
  double damping_ratio = 0.0;       // [-] -Re(lambda) / |lambda|; 1 for a decaying real root, 0 for lambda = 0
  int multiplicity = 1;             // how many eigenvalues of A are this one within rounding
  Eigen::VectorXcd shape;           // (N) of q, the largest entry 1
  Eigen::VectorXd participation;    // (N) share of each coordinate in the mode, >= 0, sum 1; free of units
  std::string name;                 // e.g. "carbody bounce", "front_bogie + rear_bogie bounce in phase"
};

/// Modes of a linear system, sorted by |lambda|.
///
/// Eigenvalues closer than the solver can tell them apart (first-order perturbation bound with their condition
/// numbers) are one; their shapes are a basis of the null space of A - lambda, each with one coordinate of its own.
/// A repeated eigenvalue with fewer shapes than its multiplicity (critical damping, free motion) gives as many modes
/// as it has shapes. Real and imaginary parts within the bound are zero.
/// Participation of coordinate i: |q_i y_i|, y the velocity half of the left eigenvector; for symmetric M, C, K this
/// is M-weighted, the share in the kinetic energy, so metres and radians compare.
/// Source: J. H. Wilkinson, The Algebraic Eigenvalue Problem, ch. 2 (condition numbers); I. J. Perez-Arriaga,
/// G. C. Verghese, F. C. Schweppe, IEEE Trans. Power Appar. Syst. 101 (1982) 3117-3125 (participation).
/// @throws std::invalid_argument if system.linear() is empty
[[nodiscard]] std::vector<Mode> modesOf(const System& system);

/// The same for the matrix alone, for example a differenced one of a nonlinear system.
/// @param A       (2N x 2N) of the state (q, q')
/// @param states  2N channels; the first N name the coordinates, "<part>.<z | pitch | ...>"
/// @throws std::invalid_argument unless A is finite and fits the states; std::runtime_error if the eigenvalue
///         iteration does not converge
[[nodiscard]] std::vector<Mode> modesOf(const Eigen::MatrixXd& A, const std::vector<Channel>& states);

}  // namespace vehicle
