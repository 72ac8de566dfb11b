#pragma once

#include "libvehicle/integrate/tableau.h"

namespace vehicle {

// What a classical step does to some entries of the state between two evaluations of f. The one place of its formulas:
// Rk4::step takes them for all entries, threads that share a run for those that each holds. The tableau has entries
// just below the diagonal only, so a stage needs the slope before it and no other; the weighted sum is gathered on the
// way.

/// After the first evaluation: begins the weighted sum and gives the arguments of the second.
/// @param x, slope, sum, stage  (n)
inline void afterFirstStage(double h, const double* x, const double* __restrict slope, double* __restrict sum,
                            double* __restrict stage, int n) {
  for (int i = 0; i < n; ++i) {
    sum[i] = kRk4.b[0] * slope[i];
    stage[i] = x[i] + h * kRk4.a[1][0] * slope[i];
  }
}

/// After evaluation kStage (1 or 2, counted from 0): gathers its weight and gives the arguments of the next.
template <std::size_t kStage>
inline void afterMiddleStage(double h, const double* x, const double* __restrict slope, double* __restrict sum,
                             double* __restrict stage, int n) {
  for (int i = 0; i < n; ++i) {
    sum[i] += kRk4.b[kStage] * slope[i];
    stage[i] = x[i] + h * kRk4.a[kStage + 1][kStage] * slope[i];
  }
}

/// After the last evaluation: x moves on.
inline void afterLastStage(double h, const double* __restrict slope, const double* __restrict sum, double* __restrict x,
                           int n) {
  for (int i = 0; i < n; ++i) x[i] += h * (sum[i] + kRk4.b[3] * slope[i]);
}

}  // namespace vehicle
