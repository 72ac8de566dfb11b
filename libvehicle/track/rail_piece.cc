#include "libvehicle/track/rail_piece.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace vehicle {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kNever = std::numeric_limits<double>::infinity();

// Adds amplitude sin(wavenumber x + phase), wavenumber of any sign.
void addSine(RailPiece& piece, double amplitude, double wavenumber, double phase) {
  if (wavenumber == 0.0) {
    piece.level += amplitude * std::sin(phase);
  } else if (wavenumber < 0.0) {
    addSine(piece, -amplitude, -wavenumber, -phase);
  } else {
    piece.waves.push_back({wavenumber, amplitude * std::sin(phase), amplitude * std::cos(phase)});
  }
}

void addHarmonics(const Track& track, std::vector<RailPiece>& pieces) {
  const bool onset = track.history == History::kOnset;
  const bool fades = onset && track.fade_in;
  RailPiece fading{.from = 0.0, .to = fades ? *track.fade_in : 0.0, .waves = {}, .samples = {}};
  RailPiece steady{.from = onset ? fading.to : -kNever, .to = kNever, .waves = {}, .samples = {}};
  for (const Harmonic& each : track.harmonics) {
    const double amplitude = shareOf(each.rail) * each.amplitude;
    if (amplitude == 0.0) continue;
    const double wavenumber = 2.0 * kPi * each.order / each.wavelength;
    addSine(steady, amplitude, wavenumber, each.phase);
    if (!fades) continue;
    const double fade = kPi / *track.fade_in;
    addSine(fading, 0.5 * amplitude, wavenumber, each.phase);
    addSine(fading, -0.25 * amplitude, wavenumber + fade, each.phase);
    addSine(fading, -0.25 * amplitude, wavenumber - fade, each.phase);
  }
  if (!fading.waves.empty()) pieces.push_back(std::move(fading));
  if (!steady.waves.empty()) pieces.push_back(std::move(steady));
}

/// A dip (height below 0) or a bump.
template <class Feature>
void addFeature(const Feature& feature, double height, std::vector<RailPiece>& pieces) {
  height *= shareOf(feature.rail);
  if (height == 0.0) return;
  RailPiece piece{
      .from = feature.start, .to = feature.start + feature.length, .origin = feature.start, .waves = {}, .samples = {}};
  if (feature.shape == DipShape::kOneMinusCosine) {
    piece.level = 0.5 * height;
    piece.waves.push_back({2.0 * kPi / feature.length, -0.5 * height, 0.0});
  } else {
    piece.waves.push_back({kPi / feature.length, 0.0, height});
  }
  pieces.push_back(std::move(piece));
}

}  // namespace

bool RailPiece::isStep() const { return slope == 0.0 && waves.empty() && !samples && std::isinf(to); }

double RailPiece::fastestWave() const {
  double fastest = samples ? samples->fastestWave() : 0.0;
  for (const RailWave& wave : waves) fastest = std::max(fastest, wave.wavenumber);
  return fastest;
}

RailPoint RailPiece::at(double s, SampledRail::Held& held) const {
  const double x = s - origin;
  RailPoint point = samples ? samples->at(s, held) : RailPoint{};
  point.height += level + slope * x;
  point.slope += slope;
  for (const RailWave& wave : waves) {
    const double k = wave.wavenumber;
    const double value = wave.cosine * std::cos(k * x) + wave.sine * std::sin(k * x);
    point.height += value;
    point.slope += k * (wave.sine * std::cos(k * x) - wave.cosine * std::sin(k * x));
    point.curvature -= k * k * value;
  }
  return point;
}

std::vector<RailPiece> piecesOf(const std::shared_ptr<const SampledRail>& samples) {
  const double begin = samples->begin(), end = samples->end();
  return {{.from = -kNever, .to = begin, .level = samples->at(begin).height, .waves = {}, .samples = {}},
          {.from = begin, .to = end, .waves = {}, .samples = samples},
          {.from = end, .to = kNever, .level = samples->at(end).height, .waves = {}, .samples = {}}};
}

std::vector<RailPiece> piecesOf(const Track& track) {
  std::vector<RailPiece> pieces;
  addHarmonics(track, pieces);
  for (const Dip& each : track.dips) addFeature(each, -each.depth, pieces);
  for (const Bump& each : track.bumps) addFeature(each, each.height, pieces);
  for (const Ramp& each : track.ramps) {
    const double rise = shareOf(each.rail) * each.rise;
    if (rise == 0.0) continue;
    const double top = each.start + each.length;
    pieces.push_back({each.start, top, each.start, 0.0, rise / each.length, {}, {}});
    pieces.push_back({top, kNever, top, rise, 0.0, {}, {}});
  }
  if (track.history == History::kOnset) {
    std::erase_if(pieces, [](const RailPiece& piece) { return piece.to <= 0.0; });
    for (RailPiece& piece : pieces) piece.from = std::max(piece.from, 0.0);
  }
  return pieces;
}

}  // namespace vehicle
