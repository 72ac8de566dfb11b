#pragma once

#include <cmath>

namespace vehicle {

/// Sine and cosine of w s, stepped by the angle w dt: what a sweep of the input turns from sample to sample.
struct Oscillator {
  double cosine, sine, turn_cosine, turn_sine;
  Oscillator(double omega, double s, double dt)
      : cosine(std::cos(omega * s)),
        sine(std::sin(omega * s)),
        turn_cosine(std::cos(omega * dt)),
        turn_sine(std::sin(omega * dt)) {}
  void turn() {
    const double turned = cosine * turn_cosine - sine * turn_sine;
    sine = sine * turn_cosine + cosine * turn_sine;
    cosine = turned;
  }
};

}  // namespace vehicle
