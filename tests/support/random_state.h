#pragma once

#include <cstddef>
#include <random>
#include <vector>

namespace vehicle::test {

/// A state and an input of the size of a run: displacements of some 5 mm, velocities of some 0.1 m/s, rail
/// accelerations of some 1 m/s^2.
struct RandomState {
  std::vector<double> x;  // (n)
  std::vector<double> u;  // (3 w)
};

/// The same sequence in every run.
inline std::vector<RandomState> randomStates(int count, std::size_t n, std::size_t w) {
  std::mt19937_64 generator(20170101);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<RandomState> states(static_cast<std::size_t>(count));
  for (RandomState& each : states) {
    each.x.resize(n);
    each.u.resize(3 * w);
    for (std::size_t i = 0; i < n; ++i) each.x[i] = (i < n / 2 ? 5e-3 : 0.1) * unit(generator);
    for (std::size_t i = 0; i < 3 * w; ++i) each.u[i] = (i < w ? 5e-3 : i < 2 * w ? 0.1 : 1.0) * unit(generator);
  }
  return states;
}

}  // namespace vehicle::test
