#include "libvehicle/track/rail_profile.h"

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

/// Height and slope of one dip or bump of unit height; `share` of its length, from 0 to 1.
double shapeAt(DipShape shape, double share) {
  return shape == DipShape::kOneMinusCosine ? 0.5 * (1.0 - std::cos(2.0 * kPi * share)) : std::sin(kPi * share);
}
double shapeSlopeAt(DipShape shape, double share) {
  return kPi * (shape == DipShape::kOneMinusCosine ? std::sin(2.0 * kPi * share) : std::cos(kPi * share));
}

}  // namespace

double railHeight(const Track& track, double s) {
  if (track.history == History::kOnset && s < 0.0) return 0.0;
  double height = 0.0;
  for (const Harmonic& each : track.harmonics) {
    const double amplitude = shareOf(each.rail) * each.amplitude;
    height += amplitude * std::sin(2.0 * kPi * each.order * s / each.wavelength + each.phase);
  }
  if (isFading(track, s, Side::kRight)) height *= 0.5 * (1.0 - std::cos(kPi * s / *track.fade_in));
  const auto addFeature = [&](const auto& each, double height_of_it) {
    const double share = (s - each.start) / each.length;
    if (share < 0.0 || share >= 1.0) return;
    height += shareOf(each.rail) * height_of_it * shapeAt(each.shape, share);
  };
  for (const Dip& each : track.dips) addFeature(each, -each.depth);
  for (const Bump& each : track.bumps) addFeature(each, each.height);
  for (const Ramp& each : track.ramps) {
    const double share = (s - each.start) / each.length;
    if (share >= 0.0) height += shareOf(each.rail) * each.rise * std::fmin(share, 1.0);
  }
  return height;
}

double railSlope(const Track& track, double s, Side side) {
  if (track.history == History::kOnset && !past(s, 0.0, side)) return 0.0;
  double height = 0.0;
  double slope = 0.0;
  for (const Harmonic& each : track.harmonics) {
    const double amplitude = shareOf(each.rail) * each.amplitude;
    const double wavenumber = 2.0 * kPi * each.order / each.wavelength;
    height += amplitude * std::sin(wavenumber * s + each.phase);
    slope += amplitude * wavenumber * std::cos(wavenumber * s + each.phase);
  }
  if (isFading(track, s, side)) {
    const double fade = kPi / *track.fade_in;
    slope = 0.5 * (1.0 - std::cos(fade * s)) * slope + 0.5 * fade * std::sin(fade * s) * height;
  }
  const auto isOn = [&](const auto& each) {
    return past(s, each.start, side) && !past(s, each.start + each.length, side);
  };
  const auto addFeature = [&](const auto& each, double height_of_it) {
    if (!isOn(each)) return;
    const double share = (s - each.start) / each.length;
    slope += shareOf(each.rail) * height_of_it / each.length * shapeSlopeAt(each.shape, share);
  };
  for (const Dip& each : track.dips) addFeature(each, -each.depth);
  for (const Bump& each : track.bumps) addFeature(each, each.height);
  for (const Ramp& each : track.ramps) {
    if (isOn(each)) slope += shareOf(each.rail) * each.rise / each.length;
  }
  return slope;
}

}  // namespace vehicle
