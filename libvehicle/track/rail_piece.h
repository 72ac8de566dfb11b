#pragma once

#include <memory>
#include <vector>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/track/rail_point.h"
#include "libvehicle/track/sampled_rail.h"

namespace vehicle {

/// cosine cos(wavenumber x) + sine sin(wavenumber x)
struct RailWave {
  double wavenumber = 0.0;  // [rad/m] > 0
  double cosine = 0.0;      // [m]
  double sine = 0.0;        // [m]
};

/// One term of the rail's height that holds on [from, to) and is nothing elsewhere; x = s - origin:
///     level + slope x + sum of waves + samples at s
struct RailPiece {
  double from = 0.0;    // [m]; -infinity: has always been there
  double to = 0.0;      // [m]; +infinity: never ends
  double origin = 0.0;  // [m]
  double level = 0.0;   // [m]
  double slope = 0.0;   // [-]
  std::vector<RailWave> waves;
  std::shared_ptr<const SampledRail> samples;  // none: the piece has a closed form

  /// Level from then on.
  [[nodiscard]] bool isStep() const;
  /// [rad/m] of its fastest wave; 0: it has none.
  [[nodiscard]] double fastestWave() const;
  /// Its own formula at any distance: outside [from, to) too, which gives the one-sided limits at its ends.
  /// @param held  as for SampledRail::at(); not read without samples
  [[nodiscard]] RailPoint at(double s, SampledRail::Held& held) const;
};

/// The rail's height, the mean of both rails, as a sum of pieces; its corners are the finite ends of the pieces. Members
/// of no height give no piece. A faded harmonic is three waves, since
///     a sin(k s + p) (1 - cos(g s))/2 = a/2 sin(k s + p) - a/4 sin((k + g) s + p) - a/4 sin((k - g) s + p),
/// g = pi / fade_in. With `onset`, pieces are cut at s = 0.
[[nodiscard]] std::vector<RailPiece> piecesOf(const Track& track);

/// A rail that is known by samples, level before the first and behind the last: one piece whatever their number, and no
/// corner but at its ends.
[[nodiscard]] std::vector<RailPiece> piecesOf(const std::shared_ptr<const SampledRail>& samples);

}  // namespace vehicle
