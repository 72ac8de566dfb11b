#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

#include "libvehicle/integrate/tableau.h"

namespace vehicle {

/// R(z): by what an explicit Runge-Kutta method multiplies x in one step of x' = lambda x, z = h lambda. The truth is
/// exp(z); where |R| > 1 the method lets a mode grow that decays. Source: Hairer, Wanner, Solving Ordinary Differential
/// Equations II, 2nd ed., ch. IV.2.
template <int S>
[[nodiscard]] std::complex<double> stabilityFunction(const Tableau<S>& method, std::complex<double> z) {
  std::array<std::complex<double>, static_cast<std::size_t>(S)> k;
  std::complex<double> x = 1.0;
  for (std::size_t i = 0; i < k.size(); ++i) {
    std::complex<double> stage = 1.0;
    for (std::size_t j = 0; j < i; ++j) stage += method.a[i][j] * k[j];
    k[i] = z * stage;
    x += method.b[i] * k[i];
  }
  return x;
}

/// What one step of a method errs by, relative to the mode: |R(z) - exp(z)|.
template <int S>
[[nodiscard]] double modeError(const Tableau<S>& method, std::complex<double> z) {
  return std::abs(stabilityFunction(method, z) - std::exp(z));
}

}  // namespace vehicle
