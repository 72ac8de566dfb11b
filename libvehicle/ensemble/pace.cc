#include "libvehicle/ensemble/pace.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vehicle {

namespace {

/// Largest row sum of the normalised stiffness, or damping, of carbody bounce and pitch and both bogies.
/// @param s1, s2  secondaries   @param p1, p2  primaries of either bogie   @param height  of the carbody's pitch (K alone)
double rowSum(const FlatParameters& v, double s1, double s2, double p1, double p2, double height) {
  const std::array<double, 4> mass = {v.mk, v.Jk, v.m1, v.m2};
  const std::array<std::array<double, 4>, 4> entry = {{
      {s1 + s2, v.lf * s1 - v.lr * s2, -s1, -s2},
      {v.lf * s1 - v.lr * s2, v.lf * v.lf * s1 + v.lr * v.lr * s2 + height, -v.lf * s1, v.lr * s2},
      {-s1, -v.lf * s1, s1 + p1, 0.0},
      {-s2, v.lr * s2, 0.0, s2 + p2},
  }};
  double largest = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    double sum = 0.0;
    for (std::size_t j = 0; j < 4; ++j) sum += std::abs(entry[i][j]) / std::sqrt(mass[i] * mass[j]);
    largest = std::max(largest, sum);
  }
  return largest;
}

}  // namespace

DesignPace paceOf(const FlatParameters& v, double duration) {
  const double k = rowSum(v, v.cs1, v.cs2, v.cp[0] + v.cp[1], v.cp[2] + v.cp[3], v.k_g);
  const double c = rowSum(v, v.bs1, v.bs2, v.bp[0] + v.bp[1], v.bp[2] + v.bp[3], 0.0);
  // 120 * 0.05 = remembered h^4 lambda^5: a motion that swings is remembered for the whole run, a real root for 1/lambda.
  constexpr double kLoss = 6.0;
  DesignPace pace;
  pace.fastest = std::sqrt(k);
  pace.step = std::pow(kLoss / (duration * k * k * pace.fastest), 0.25);
  if (c * c < 4.0 * k) return pace;
  pace.fastest = 0.5 * c + std::sqrt(0.25 * c * c + k);
  pace.step = std::min(pace.step, std::pow(kLoss, 0.25) / pace.fastest);
  return pace;
}

}  // namespace vehicle
