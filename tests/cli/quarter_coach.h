#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <functional>

// The quarter coach of cases/quarter-hertz.xml by hand: body, frame and axle above each other.
namespace vehicle::test {

struct QuarterCoach {
  double body = 8e3, frame = 1.3e3, axle = 1.8e3;          // [kg]
  double secondary = 430e3, primary = 2.4e6;               // [N/m]
  double secondary_damping = 20e3, primary_damping = 8e3;  // [N s/m]
  double load = (8e3 + 1.3e3 + 1.8e3) * 9.81;              // static, of the wheelset [N]
  double contact =
      1.5 * std::pow(187.5e9, 2.0 / 3.0) * std::cbrt((8e3 + 1.3e3 + 1.8e3) * 9.81);  // dF/dz of Hertz [N/m]
};

/// Amplitude of the frame's acceleration over a rail a sin(w t): the three rows of (K + i w C - w^2 M) z = (0, 0, k a).
inline double frameAcceleration(const QuarterCoach& coach, double a, double w) {
  using C = std::complex<double>;
  const C second(coach.secondary, w * coach.secondary_damping), first(coach.primary, w * coach.primary_damping);
  const C of_body = second / (second - coach.body * w * w);                              // body over frame
  const C of_frame = first / (first + second - coach.frame * w * w - second * of_body);  // frame over axle
  const C axle = coach.contact * a / (coach.contact + first - coach.axle * w * w - first * of_frame);
  return w * w * std::abs(of_frame * axle);
}

struct LowestLoad {
  double load = HUGE_VAL;  // [N]
  double time = 0.0;       // [s]
};

/// Its smallest wheel load over 2 s from rest, by the classical Runge-Kutta method at 20 us, which resolves its fastest
/// motion (1150 rad/s) to (1150 * 20e-6)^4 / 120 = 2e-9 a step.
/// @param rail  height of the rail [m] at a time [s]; its corners have to be multiples of 20 us
inline LowestLoad lowestLoad(const QuarterCoach& coach, const std::function<double(double)>& rail) {
  using State = std::array<double, 6>;  // z of body, frame, axle, and their rates
  const auto rates = [&](const State& x, double t) {
    const double second = coach.secondary * (x[0] - x[1]) + coach.secondary_damping * (x[3] - x[4]);
    const double first = coach.primary * (x[1] - x[2]) + coach.primary_damping * (x[4] - x[5]);
    const double push = coach.contact * (rail(t) - x[2]);
    return State{x[3], x[4], x[5], -second / coach.body, (second - first) / coach.frame, (first + push) / coach.axle};
  };
  const auto moved = [](const State& x, const State& rate, double by) {
    State to = x;
    for (std::size_t i = 0; i < to.size(); ++i) to[i] += by * rate[i];
    return to;
  };
  constexpr double kStep = 20e-6;
  LowestLoad lowest;
  State x{};
  for (int i = 0; i < 100'000; ++i) {
    const double t = i * kStep;
    const double load = coach.load + coach.contact * (rail(t) - x[2]);
    if (load < lowest.load) lowest = {load, t};
    const State a = rates(x, t), b = rates(moved(x, a, 0.5 * kStep), t + 0.5 * kStep);
    const State c = rates(moved(x, b, 0.5 * kStep), t + 0.5 * kStep), d = rates(moved(x, c, kStep), t + kStep);
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += kStep / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
  }
  return lowest;
}

}  // namespace vehicle::test
