#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "libvehicle/system/input.h"
#include "libvehicle/system/system.h"

namespace vehicle {

/// Moves the state of x' = A x + sum_f [ forcing(:,2f) cos(w_f s) + forcing(:,2f+1) sin(w_f s) ] by exactly h:
///
///     x(s + h) = x(s) + E x(s) + sum_f [ gain(:,2f) cos(w_f s) + gain(:,2f+1) sin(w_f s) ],    E = e^(A h) - I
///
/// E and the gains are blocks of the exponential of the augmented matrix [A G; 0 W], balanced by powers of two.
/// Beyond kMostAugmented frequencies the gains come from the particular solution X = (i w - A)^-1 G of each
/// frequency, gain = X (e^(i w h) - 1) - E X; where X is so large that the difference would cancel (w near an
/// undamped mode) that frequency goes through an augmented exponential of its own.
/// Constructing allocates, propagating never does.
/// Source: C. F. Van Loan, IEEE Trans. Autom. Control 23 (1978) 395-404.
class ExactPropagator {
 public:
  static constexpr int kMostAugmented = 10;

  /// @param A        (n x n)
  /// @param forcing  (n x 2 F)
  /// @param angular_frequency  [rad/s] (F) >= 0
  /// @param length   h [s] > 0
  /// @throws std::invalid_argument naming the argument that breaks a rule
  ExactPropagator(const Eigen::MatrixXd& A, const Eigen::MatrixXd& forcing, std::vector<double> angular_frequency,
                  double length);

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] int frequencies() const { return static_cast<int>(angular_frequency_.size()); }
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] int exponentials() const { return exponentials_; }  // computed by the constructor

  /// (cos w_f s, sin w_f s) of every frequency.
  /// @param oscillators  (2 F)
  void seed(double s, double* oscillators) const;

  /// x and the oscillators from s to s + h. The oscillators turn by a rotation that rounds: seed them anew now and
  /// then (after 64 steps they are within 1e-14).
  /// @param x  (n), updated in place   @param oscillators  (2 F), updated in place
  void propagate(double* x, double* oscillators) { (this->*kernel_)(x, oscillators); }

 private:
  template <int N, int F>
  void kernel(double* x, double* oscillators);
  void generalKernel(double* x, double* oscillators);

  int size_;
  std::vector<double> angular_frequency_;
  double length_;
  int exponentials_ = 0;
  std::vector<double> columns_;    // (n x (n + 2 F)) column-major: E, then the gains
  std::vector<double> turn_;       // (2 F) cos(w_f h), sin(w_f h)
  std::vector<double> increment_;  // (n) scratch of the general kernel
  void (ExactPropagator::*kernel_)(double*, double*) = nullptr;
};

/// What a cubic polynomial in every channel adds to x over one step of length h:
///
///     x(s + h) = e^(A h) x(s) + sum_k gain_k eta^(k)(s),    k = 0..3
///
/// The gains know A, B and h only, so one serves every segment of an input that is stored sample by sample.
class PolynomialGain {
 public:
  /// @param system  A (n x n), B (n x 2 w)   @param length  h [s] > 0
  PolynomialGain(const StateSpace& system, double length);

  [[nodiscard]] double length() const { return length_; }

  /// x += the effect of the segment's polynomials from s = t - segment.begin to s + h.
  /// @param x  (n)
  void add(const InputSegment& segment, double s, double* x) const;

 private:
  double length_;
  Eigen::MatrixXd gain_;  // (n x 4 w): column k w + j answers the k-th derivative of eta_j
};

/// Columns through which cos(w_f s) and sin(w_f s) of a segment drive the states: B (eta, eta') sorted by function.
/// @return  (n x 2 F): column 2f for the cosine, 2f + 1 for the sine
[[nodiscard]] Eigen::MatrixXd harmonicForcing(const StateSpace& system, const InputSegment& segment);

}  // namespace vehicle
