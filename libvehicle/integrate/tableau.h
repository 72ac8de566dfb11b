#pragma once

#include <array>

namespace vehicle {

/// Coefficients of an explicit Runge-Kutta method of S stages, as data:
///
///     k_i = f(x + h sum_j a(i,j) k_j, u(t + c_i h)),   x(t + h) = x + h sum_i b_i k_i
///
/// tests/integrate/tableau_test.cc checks them against the order conditions, not against another copy.
template <int S>
struct Tableau {
  static constexpr int kStages = S;
  std::array<double, S> c;                 // [-] (S)
  std::array<std::array<double, S>, S> a;  // [-] (S x S), strictly lower triangular
  std::array<double, S> b;                 // [-] (S)
};

/// The classical method of order 4 (Kutta 1901).
/// Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed., table II.1.2.
inline constexpr Tableau<4> kRk4{
    .c = {0.0, 1.0 / 2, 1.0 / 2, 1.0},
    .a = {{{}, {1.0 / 2}, {0.0, 1.0 / 2}, {0.0, 0.0, 1.0}}},
    .b = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6},
};

/// Dormand and Prince, order 5 with an embedded order 4. The last stage is f at the new point and serves as first
/// stage of the next step.
/// Source: Hairer, Norsett, Wanner I, 2nd ed., table II.5.2; J. R. Dormand, P. J. Prince, J. Comp. Appl. Math. 6
/// (1980) 19-26.
inline constexpr Tableau<7> kDopri5{
    .c = {0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0},
    .a = {{{},
           {1.0 / 5},
           {3.0 / 40, 9.0 / 40},
           {44.0 / 45, -56.0 / 15, 32.0 / 9},
           {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
           {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
           {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}}},
    .b = {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84, 0.0},
};

/// Weights of the embedded solution of order 4; b - this, times h, estimates the local error.
inline constexpr std::array<double, 7> kDopri5Embedded{
    5179.0 / 57600, 0.0, 7571.0 / 16695, 393.0 / 640, -92097.0 / 339200, 187.0 / 2100, 1.0 / 40};

/// Shampine's coefficients d of the continuous extension of order 4, as Hairer arranges it:
///
///     b_i(s) = s { b_i + (1-s) [ e_i1 - b_i + s ( 2 b_i - e_i1 - e_i7 + (1-s) d_i ) ] },   0 <= s <= 1
///
/// with e_ij = 1 if i = j, else 0. The interpolant is once continuously differentiable.
/// Source: Hairer, Norsett, Wanner I, 2nd ed., II.6, eq. (6.13) and subroutine CONTD5.
inline constexpr std::array<double, 7> kDopri5Dense{
    -12715105075.0 / 11282082432.0,   0.0, 87487479700.0 / 32700410799.0, -10690763975.0 / 1880347072.0,
    701980252875.0 / 199316789632.0, -1453857185.0 / 822651844.0, 69997945.0 / 29380423.0};

/// b_i(s) of the continuous extension of kDopri5.
[[nodiscard]] constexpr double dopri5DenseWeight(int stage, double s) {
  const auto i = static_cast<std::size_t>(stage);
  const double first = stage == 0 ? 1.0 : 0.0;
  const double last = stage == 6 ? 1.0 : 0.0;
  const double b = kDopri5.b[i];
  return s * (b + (1.0 - s) * (first - b + s * (2.0 * b - first - last + (1.0 - s) * kDopri5Dense[i])));
}

}  // namespace vehicle
