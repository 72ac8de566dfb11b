#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "libvehicle/ensemble/ensemble.h"
#include "libvehicle/integrate/fixed_step_run.h"
#include "libvehicle/integrate/rk4.h"
#include "tests/support/tolerance.h"

// The witness: one design at a time by runFixedStep() and the columns of flat/flat_form.cc written anew.
namespace vehicle::test {

/// All columns of a design at one instant.
/// @param u  (12) heights, rates, accelerations of the rail
inline std::vector<double> columnsAt(const EnsembleDesign& design, const double* x, const double* u) {
  const FlatParameters& v = design.vehicle;
  std::array<double, 8> dx{};
  const FlatRhs rhs(v);
  rhs(x, u, dx.data());
  const double front = x[0] + v.lf * x[1] - x[2];
  const double rear = x[0] - v.lr * x[1] - x[3];
  std::vector<double> y = {x[0], x[1], x[4], x[5], dx[4], dx[5], x[2], x[6], dx[6], x[3], x[7], dx[7],
                           front, v.cs1 * front + v.bs1 * (x[4] + v.lf * x[5] - x[6]),
                           rear, v.cs2 * rear + v.bs2 * (x[4] - v.lr * x[5] - x[7])};
  std::array<double, 4> force{};
  for (std::size_t j = 0; j < 4; ++j) {
    const double d = x[j < 2 ? 2 : 3] - u[j];
    force[j] = v.cp[j] * d + v.bp[j] * (x[j < 2 ? 6 : 7] - u[4 + j]);
    y.insert(y.end(), {d, force[j]});
  }
  for (std::size_t j = 0; j < 4; ++j) {
    y.insert(y.end(), {u[j], design.wheel_load[j] - force[j] + design.wheelset_mass[j] * u[8 + j]});
  }
  for (const double arm : design.point_arm) {
    y.insert(y.end(), {x[0] + arm * x[1], x[4] + arm * x[5], dx[4] + arm * dx[5]});
  }
  return y;
}

/// History of all columns, shape (samples)(columns), samples before `first` left out.
inline std::vector<std::vector<double>> historyOf(const EnsembleDesign& design, const Input& rail,
                                                  const EnsembleRun& run, int first = 0) {
  std::vector<std::vector<double>> history;
  Rk4<FlatRhs, 8> stepper{FlatRhs(design.vehicle)};
  const Schedule schedule(rail, run.output_step);
  runFixedStep(stepper, rail, schedule, run.step, design.start,
               [&](int sample, int segment, double t, std::span<const double> x) {
                 if (sample < first) return true;
                 std::array<double, 12> u{};
                 rail.evaluate(segment, t, u);
                 history.push_back(columnsAt(design, x.data(), u.data()));
                 return true;
               });
  return history;
}

/// Summary of a column of a history.
inline ColumnSummary summaryOf(const std::vector<std::vector<double>>& history, std::size_t column) {
  ColumnSummary s{0.0, 0.0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const std::vector<double>& row : history) {
    s.mean += row[column];
    s.rms += row[column] * row[column];
    s.lowest = std::min(s.lowest, row[column]);
    s.highest = std::max(s.highest, row[column]);
  }
  s.mean /= static_cast<double>(history.size());
  s.rms = std::sqrt(s.rms / static_cast<double>(history.size()));
  return s;
}

/// Largest |value| of a column.
inline double peakOf(const std::vector<std::vector<double>>& history, std::size_t column) {
  double peak = 0.0;
  for (const std::vector<double>& row : history) peak = std::max(peak, std::abs(row[column]));
  return peak;
}

}  // namespace vehicle::test
