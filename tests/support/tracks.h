#pragma once

#include <random>

#include "libvehicle/definition/scenario.h"
#include "tests/support/vehicles.h"

// Tracks, and scenarios over them.
namespace vehicle::test {

/// A dip or bump of no height yet.
template <class Feature>
Feature featureOf(DipShape shape, double length, double start) {
  Feature made;
  made.shape = shape;
  made.length = length;
  made.start = start;
  return made;
}

inline Dip dip(DipShape shape, double depth, double length, double start) {
  Dip made = featureOf<Dip>(shape, length, start);
  made.depth = depth;
  return made;
}

inline Bump bump(DipShape shape, double height, double length, double start) {
  Bump made = featureOf<Bump>(shape, length, start);
  made.height = height;
  return made;
}

inline Ramp ramp(double rise, double length, double start) {
  Ramp made;
  made.rise = rise;
  made.length = length;
  made.start = start;
  return made;
}

/// A scenario of that track, `duration` seconds at 20 m/s, a sample every 5 ms.
inline Scenario scenarioOf(const Track& track, double duration) {
  Scenario made = paperScenario(track.history);
  made.track = track;
  made.run.duration = duration;
  return made;
}

/// Three harmonics of random phase (faded in with onset), eight dips of both shapes, four bumps and four ramps, on one
/// rail or both: overlapping, with `extended` also where the vehicle stands at t = 0 and behind it.
inline Track anyTrack(History history, unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Track track;
  track.history = history;
  if (history == History::kOnset) track.fade_in = between(5.0, 60.0);
  for (int i = 0; i < 3; ++i) {
    track.harmonics.push_back(harmonic(between(2.0, 40.0), between(0.5, 3.0), between(-5e-3, 5e-3), between(-9, 9)));
  }
  const double earliest = history == History::kOnset ? 0.0 : -30.0;
  for (int i = 0; i < 8; ++i) {
    const DipShape shape = i % 2 == 0 ? DipShape::kOneMinusCosine : DipShape::kHalfSine;
    track.dips.push_back(dip(shape, between(-9e-3, 9e-3), between(0.5, 12.0), between(earliest, 80.0)));
  }
  for (int i = 0; i < 4; ++i) {
    track.ramps.push_back(ramp(between(-9e-3, 9e-3), between(1.0, 12.0), between(earliest, 80.0)));
    track.bumps.push_back(bump(DipShape::kHalfSine, between(-9e-3, 9e-3), between(0.5, 12.0), between(earliest, 80.0)));
  }
  // Every third member lies on one rail.
  int member = 0;
  const auto place = [&member](auto& each) {
    each.rail = member % 3 != 0 ? RailSide::kBoth : member % 2 == 0 ? RailSide::kLeft : RailSide::kRight;
    ++member;
  };
  for (Harmonic& each : track.harmonics) place(each);
  for (Dip& each : track.dips) place(each);
  for (Bump& each : track.bumps) place(each);
  for (Ramp& each : track.ramps) place(each);
  return track;
}

}  // namespace vehicle::test
