#pragma once

#include <cassert>
#include <cmath>
#include <complex>
#include <vector>

// Closed-form motions. They share no line with the library: pieces of rail are told in their own struct.
namespace vehicle::test {

/// Height of the rail under one wheel between two breakpoints, with s = t - begin:
///     eta(s) = offset + slope s + sum_f Re[ Y_f e^(i w_f s) ]
struct RailPiece {
  struct Wave {
    double angular_frequency;        // w [rad/s]
    std::complex<double> amplitude;  // Y [m]; -i a for a sin(w s)
  };
  double begin = 0.0;   // [s]
  double end = 0.0;     // [s]
  double offset = 0.0;  // [m]
  double slope = 0.0;   // [m/s]
  std::vector<Wave> waves;
};

struct MassState {
  double z = 0.0;  // [m]
  double v = 0.0;  // [m/s]
};

/// One mass driven through springs and dampers, some to the rail and maybe some to the fixed ground:
///     m z'' + c z' + k z = c_rail eta' + k_rail eta
/// Underdamped (c^2 < 4 m k). With c_rail = c, k_rail = k it is the base-excited mass; without rail motion the
/// decaying oscillator z = e^(-sigma s) (a cos w_d s + b sin w_d s).
/// Source: any text on linear vibration, e.g. Magnus, Popp, Schwingungen, 7th ed., ch. 2 (free) and 4 (forced).
struct DrivenMass {
  double mass = 1.0;
  double damping = 0.0;
  double stiffness = 1.0;
  double rail_damping = 0.0;
  double rail_stiffness = 1.0;

  /// Motion at s of the particular solution: a straight line and one complex amplitude a wave.
  [[nodiscard]] MassState particular(const RailPiece& rail, double s) const {
    const double line_slope = rail_stiffness * rail.slope / stiffness;
    const double line_offset =
        (rail_damping * rail.slope + rail_stiffness * rail.offset - damping * line_slope) / stiffness;
    MassState motion{line_offset + line_slope * s, line_slope};
    for (const RailPiece::Wave& wave : rail.waves) {
      const std::complex<double> iw(0.0, wave.angular_frequency);
      const std::complex<double> amplitude = (rail_stiffness + iw * rail_damping) /
                                             (stiffness + iw * damping + iw * iw * mass) * wave.amplitude *
                                             std::exp(iw * s);
      motion.z += amplitude.real();
      motion.v += (iw * amplitude).real();
    }
    return motion;
  }

  /// Motion at s after `start` at s = 0.
  [[nodiscard]] MassState after(MassState start, const RailPiece& rail, double s) const {
    const double sigma = 0.5 * damping / mass;
    const double wd = std::sqrt(stiffness / mass - sigma * sigma);
    assert(wd > 0.0);
    const MassState p0 = particular(rail, 0.0);
    const double a = start.z - p0.z;
    const double b = (start.v - p0.v + sigma * a) / wd;
    const double decay = std::exp(-sigma * s);
    const double cosine = std::cos(wd * s);
    const double sine = std::sin(wd * s);
    const MassState p = particular(rail, s);
    return {p.z + decay * (a * cosine + b * sine),
            p.v + decay * ((b * wd - sigma * a) * cosine - (a * wd + sigma * b) * sine)};
  }

  /// Motion at t over a rail of several pieces, from `start` at the begin of the first.
  [[nodiscard]] MassState at(MassState start, const std::vector<RailPiece>& rail, double t) const {
    for (const RailPiece& piece : rail) {
      if (t <= piece.end || &piece == &rail.back()) return after(start, piece, t - piece.begin);
      start = after(start, piece, piece.end - piece.begin);
    }
    return start;
  }

  [[nodiscard]] double energy(MassState motion) const {
    return 0.5 * mass * motion.v * motion.v + 0.5 * stiffness * motion.z * motion.z;
  }
};

/// Two equal masses, each on an equal spring and damper to the rail under it, joined by a third pair (kc, cc).
/// Their mean moves like a mass on (k, c), half their difference like one on (k + 2 kc, c + 2 cc), each driven by
/// the mean and half the difference of the two rails through (k, c).
/// Source: symmetry; natural frequencies sqrt(k/m), sqrt((k + 2 kc)/m) as in any text on linear vibration.
struct TwoMasses {
  double mass = 1.0;
  double damping = 0.0;
  double stiffness = 1.0;
  double joint_damping = 0.0;
  double joint_stiffness = 1.0;

  [[nodiscard]] DrivenMass mean() const { return {mass, damping, stiffness, damping, stiffness}; }
  [[nodiscard]] DrivenMass difference() const {
    return {mass, damping + 2.0 * joint_damping, stiffness + 2.0 * joint_stiffness, damping, stiffness};
  }
};

}  // namespace vehicle::test
