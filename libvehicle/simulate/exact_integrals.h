#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libvehicle/linear/column_derivatives.h"
#include "libvehicle/system/schedule.h"

namespace vehicle {

/// Integrals of columns and of their squares over a smooth part of an exact run, to rounding.
///
/// The samples of equal intervals are summed by the trapezoidal rule, and what that owes to the ends is taken off by the
/// Euler-Maclaurin formula up to h^12: the motion of a linear system has all its derivatives in closed form
/// (ColumnDerivatives). A shorter interval at an end is integrated as its Taylor series. Both series fall by a hundred a
/// term where h |lambda| <= kMostTurn.
/// Source: M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions, 23.1.30.
class ExactIntegrals {
 public:
  static constexpr double kMostTurn = 0.5;

  /// @param system  linear
  ExactIntegrals(const System& system, const Input& input, const Schedule& schedule);

  /// The first sample of a part.
  void begin(const Schedule::Part& part, double t, std::span<const double> x);
  /// The sample at the end of interval number `own` of the part, seen from inside.
  /// @param y  (columns) there
  void add(std::size_t own, double t, std::span<const double> x, std::span<const double> y);

  [[nodiscard]] const std::vector<double>& first() const { return first_; }    // (columns) int y dt
  [[nodiscard]] const std::vector<double>& second() const { return second_; }  // (columns) int y^2 dt
  [[nodiscard]] double time() const { return time_; }                          // [s] so far

 private:
  void addSample(double weight, std::span<const double> y);
  void addEnd(double t, std::span<const double> x, double sign);
  void addTaylor(double t, std::span<const double> x, double length);

  const Input& input_;
  const Schedule& schedule_;
  ColumnDerivatives derivatives_;
  std::vector<double> first_, second_;
  double time_ = 0.0;

  int segment_ = 0;
  std::size_t intervals_ = 0;
  double point_step_ = 0.0;
  bool odd_first_ = false, odd_last_ = false;  // intervals at the ends that are no whole point step
  double last_length_ = 0.0;
};

}  // namespace vehicle
