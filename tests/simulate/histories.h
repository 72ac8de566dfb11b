#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "libvehicle/result/time_history.h"
#include "libvehicle/simulate/simulate.h"

namespace vehicle::test {

inline double peakOf(const std::vector<double>& values) {
  double peak = 0.0;
  for (const double value : values) peak = std::max(peak, std::abs(value));
  return peak;
}

/// Largest difference of one column, as a share of the reference column's peak (absolute where that is 0).
inline double columnError(const std::vector<double>& actual, const std::vector<double>& reference) {
  double worst = 0.0;
  if (actual.size() != reference.size()) return INFINITY;
  for (std::size_t i = 0; i < actual.size(); ++i) worst = std::max(worst, std::abs(actual[i] - reference[i]));
  const double peak = peakOf(reference);
  return peak > 0.0 ? worst / peak : worst;
}

/// Largest columnError over all columns after time. Wheel loads count by their dynamic part: against the static
/// part an error would look small.
inline double historyError(const TimeHistory& actual, const TimeHistory& reference) {
  double worst = 0.0;
  for (std::size_t column = 1; column < reference.columns().size(); ++column) {
    const std::string& name = reference.columns()[column].name;
    if (actual.columns()[column].name != name) return INFINITY;
    if (name.ends_with(".load")) continue;  // Q0 minus the primary force, which is a column of its own
    worst = std::max(worst, columnError(actual.column(column), reference.column(column)));
  }
  return worst;
}

inline RunResult run(const Vehicle& vehicle, const Scenario& scenario, const std::string& form,
                     const std::string& method, RunChoice choice = {}) {
  choice.form = form;
  choice.method = method;
  return simulate(vehicle, scenario, choice);
}

}  // namespace vehicle::test
