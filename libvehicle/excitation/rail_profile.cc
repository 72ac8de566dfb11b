#include "libvehicle/excitation/rail_profile.h"

#include <cmath>
#include <numbers>

namespace vehicle {
namespace {

constexpr double kPi = std::numbers::pi;

// Is s beyond this corner, seen from that side?
bool past(double s, double corner, Side side) { return side == Side::kRight ? s >= corner : s > corner; }

bool isFading(const Track& track, double s, Side side) {
  return track.history == History::kOnset && track.fade_in && !past(s, *track.fade_in, side);
}

}  // namespace

double railHeight(const Track& track, double s) {
  if (track.history == History::kOnset && s < 0.0) return 0.0;
  double height = 0.0;
  for (const Harmonic& each : track.harmonics) {
    height += each.amplitude * std::sin(2.0 * kPi * each.order * s / each.wavelength + each.phase);
  }
  if (isFading(track, s, Side::kRight)) height *= 0.5 * (1.0 - std::cos(kPi * s / *track.fade_in));
  for (const Dip& each : track.dips) {
    const double share = (s - each.start) / each.length;
    if (share < 0.0 || share >= 1.0) continue;
    height -= each.depth * (each.shape == DipShape::kOneMinusCosine ? 0.5 * (1.0 - std::cos(2.0 * kPi * share))
                                                                    : std::sin(kPi * share));
  }
  for (const Ramp& each : track.ramps) {
    const double share = (s - each.start) / each.length;
    if (share >= 0.0) height += each.rise * std::fmin(share, 1.0);
  }
  return height;
}

double railSlope(const Track& track, double s, Side side) {
  if (track.history == History::kOnset && !past(s, 0.0, side)) return 0.0;
  double height = 0.0;
  double slope = 0.0;
  for (const Harmonic& each : track.harmonics) {
    const double wavenumber = 2.0 * kPi * each.order / each.wavelength;
    height += each.amplitude * std::sin(wavenumber * s + each.phase);
    slope += each.amplitude * wavenumber * std::cos(wavenumber * s + each.phase);
  }
  if (isFading(track, s, side)) {
    const double fade = kPi / *track.fade_in;
    slope = 0.5 * (1.0 - std::cos(fade * s)) * slope + 0.5 * fade * std::sin(fade * s) * height;
  }
  for (const Dip& each : track.dips) {
    if (!past(s, each.start, side) || past(s, each.start + each.length, side)) continue;
    const double share = (s - each.start) / each.length;
    slope -= each.depth * kPi / each.length *
             (each.shape == DipShape::kOneMinusCosine ? std::sin(2.0 * kPi * share) : std::cos(kPi * share));
  }
  for (const Ramp& each : track.ramps) {
    if (past(s, each.start, side) && !past(s, each.start + each.length, side)) slope += each.rise / each.length;
  }
  return slope;
}

}  // namespace vehicle
