#pragma once

#include <complex>
#include <vector>

#include <Eigen/Core>

#include "libvehicle/system/system.h"

namespace vehicle {

/// How fast the motions of a linear system are: what steps and samples have to follow.
///
/// From the eigenvalues of A up to kMostStates states; beyond, the largest |lambda| alone, by iteration from outside: a
/// train has its vehicles' motions many times.
class MotionRates {
 public:
  static constexpr int kMostStates = 128;

  /// @param system  linear: f(x, 0) is asked, and the matrices where states are few
  explicit MotionRates(const System& system);
  explicit MotionRates(const Eigen::MatrixXd& A);

  /// [rad/s] max |lambda|
  [[nodiscard]] double fastest() const { return fastest_; }
  /// [rad/s] of the fastest motion that shows: max |lambda|, at most kDecays times the highest natural frequency of the
  /// undamped system. What decays faster is over before anything else has moved.
  [[nodiscard]] double fastestToShow() const;
  static constexpr double kDecays = 20.0;
  /// [1/s] how fast a motion grows by itself, max Re lambda; 0 where none does beyond rounding, or where it is not known.
  [[nodiscard]] double growth() const;
  /// max |lambda| over the lowest natural frequency of the undamped system that has a stiffness: how much larger the
  /// terms are than the motions that they leave. 1 where it is not known.
  [[nodiscard]] double spread() const { return slowest_ > 0.0 ? fastest_ / slowest_ : 1.0; }

  /// Largest step at which the classical Runge-Kutta method follows every mode, so that its error falls with order 4 and
  /// Richardson's extrapolation shows it. A mode loses |h lambda|^5 / 120 of itself a step; over the steps that it
  /// remembers, or the whole run, that stays below 1/20. Such a step is stable too: a mode on the real axis has
  /// h |lambda| < 1.6, of 2.8 allowed.
  /// @param duration  [s] of the run
  [[nodiscard]] double resolvingRk4Step(double duration) const;

  /// Whether one rk4 step of that size makes a motion grow that by itself does not: |R(h lambda)| > 1, R the stability
  /// function 1 + z + z^2/2 + z^3/6 + z^4/24.
  /// Source: Hairer, Wanner, Solving Ordinary Differential Equations II, 2nd ed., IV.2.
  [[nodiscard]] bool rk4Grows(double step) const;

 private:
  void setFrom(const Eigen::MatrixXd& A);

  std::vector<std::complex<double>> eigenvalues_;  // empty where there are too many states
  double norm_ = 0.0;                              // of the balanced matrix [1/s]
  double fastest_ = 0.0;
  double slowest_ = 0.0, stiffest_ = 0.0;  // [rad/s] of the undamped system, of what has a stiffness
};

}  // namespace vehicle
