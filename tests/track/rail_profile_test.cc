#include "libvehicle/track/rail_profile.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/tolerance.h"
#include "tests/support/tracks.h"

namespace vehicle {
namespace {

using test::dip;
using test::ramp;

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-17;  // of millimetres

Track extended() {
  Track track;
  track.history = History::kExtended;
  return track;
}

TEST(RailProfile, HarmonicHasItsAmplitudeAQuarterWaveOn) {
  Track track = extended();
  track.harmonics = {test::harmonic(25.0, 1.0, 5e-3)};
  EXPECT_EQ(railHeight(track, 0.0), 0.0);
  EXPECT_WITHIN(railHeight(track, 6.25), 5e-3, kRounding);
  EXPECT_WITHIN(railSlope(track, 0.0), 5e-3 * 2 * kPi / 25.0, kRounding);
  EXPECT_WITHIN(railHeight(track, -6.25), -5e-3, kRounding);
  track.harmonics[0].order = 2.0;
  EXPECT_WITHIN(railHeight(track, 3.125), 5e-3, kRounding);
  track.harmonics[0].phase = kPi / 2;
  EXPECT_WITHIN(railHeight(track, 0.0), 5e-3, kRounding);
}

TEST(RailProfile, OnsetIsFlatBeforeItBeginsAndHasACornerThere) {
  Track track;
  track.harmonics = {test::harmonic(25.0, 1.0, 5e-3)};
  EXPECT_EQ(railHeight(track, -6.25), 0.0);
  EXPECT_EQ(railSlope(track, 0.0, Side::kLeft), 0.0);
  EXPECT_WITHIN(railSlope(track, 0.0, Side::kRight), 5e-3 * 2 * kPi / 25.0, kRounding);
}

TEST(RailProfile, FadeInStartsAtNothingAndEndsAtTheWholeHarmonic) {
  Track track;
  track.fade_in = 50.0;
  track.harmonics = {test::harmonic(25.0, 1.0, 5e-3, kPi / 2)};
  EXPECT_EQ(railHeight(track, 0.0), 0.0);
  EXPECT_EQ(railSlope(track, 0.0), 0.0);
  EXPECT_WITHIN(railHeight(track, 25.0), 2.5e-3, kRounding);  // half faded
  EXPECT_WITHIN(railHeight(track, 50.0), 5e-3, kRounding);
  EXPECT_WITHIN(railHeight(track, 75.0), 5e-3, kRounding);
  EXPECT_WITHIN(railSlope(track, 50.0, Side::kLeft), railSlope(track, 50.0, Side::kRight), kRounding);
}

TEST(RailProfile, DepthIsPositiveDownward) {
  for (const DipShape shape : {DipShape::kOneMinusCosine, DipShape::kHalfSine}) {
    Track track = extended();
    track.dips = {dip(shape, 20e-3, 3.0, 10.0)};
    EXPECT_EQ(railHeight(track, 9.9), 0.0);
    EXPECT_WITHIN(railHeight(track, 11.5), -20e-3, kRounding);
    EXPECT_EQ(railHeight(track, 13.1), 0.0);
    EXPECT_EQ(railSlope(track, 10.0, Side::kLeft), 0.0);
    EXPECT_EQ(railSlope(track, 13.0, Side::kRight), 0.0);
    const double corner = shape == DipShape::kHalfSine ? -20e-3 * kPi / 3.0 : 0.0;
    EXPECT_WITHIN(railSlope(track, 10.0, Side::kRight), corner, kRounding);
    EXPECT_WITHIN(railSlope(track, 13.0, Side::kLeft), -corner, kRounding);
  }
}

TEST(RailProfile, RampStaysUp) {
  Track track = extended();
  track.ramps = {ramp(30e-3, 6.0, 2.0)};
  EXPECT_EQ(railHeight(track, 1.9), 0.0);
  EXPECT_WITHIN(railHeight(track, 5.0), 15e-3, kRounding);
  EXPECT_EQ(railHeight(track, 1e6), 30e-3);
  EXPECT_EQ(railSlope(track, 2.0, Side::kLeft), 0.0);
  EXPECT_WITHIN(railSlope(track, 2.0), 5e-3, kRounding);
  EXPECT_WITHIN(railSlope(track, 8.0, Side::kLeft), 5e-3, kRounding);
  EXPECT_EQ(railSlope(track, 8.0), 0.0);
}

// The slope is the derivative of the height: central difference, error h^2 k^3 a / 6 ~ 1e-12 at h = 1e-4 m.
TEST(RailProfile, SlopeIsTheDerivativeOfTheHeight) {
  Track track;
  track.fade_in = 31.0;
  track.harmonics = {test::harmonic(25.0, 1.0, 5e-3, 0.4), test::harmonic(25.0, 3.0, 2e-3, -1.0)};
  track.dips = {dip(DipShape::kOneMinusCosine, 9e-3, 5.0, 3.0), dip(DipShape::kHalfSine, -4e-3, 7.0, 20.0)};
  track.ramps = {ramp(-11e-3, 9.0, 22.0)};
  const double h = 1e-4;
  for (int i = 0; i < 200; ++i) {
    const double s = 0.2501 * i + 0.0137;  // never within h of a corner
    const double difference = (railHeight(track, s + h) - railHeight(track, s - h)) / (2 * h);
    EXPECT_WITHIN(railSlope(track, s), difference, 2e-11);  // truncation, and rounding 1e-17 / 1e-4 = 1e-13
  }
}

TEST(RailProfile, BumpIsADipUpsideDown) {
  for (const DipShape shape : {DipShape::kOneMinusCosine, DipShape::kHalfSine}) {
    Track down = extended();
    Track up = extended();
    down.dips = {dip(shape, 8e-3, 4.0, 3.0)};
    up.bumps = {test::bump(shape, 8e-3, 4.0, 3.0)};
    EXPECT_WITHIN(railHeight(up, 5.0), 8e-3, kRounding);  // its middle
    for (const double s : {2.9, 3.0, 3.7, 5.0, 6.99, 7.0, 8.0}) {
      EXPECT_EQ(railHeight(up, s), -railHeight(down, s)) << s;
      EXPECT_EQ(railSlope(up, s), -railSlope(down, s)) << s;
    }
  }
}

// The mean of both rails: 8 mm on both are 8 mm, by one member or by two; on one rail they are 4 mm.
TEST(RailProfile, IsTheMeanOfBothRails) {
  const auto heightOf = [](std::vector<RailSide> rails) {
    Track track = extended();
    for (const RailSide rail : rails) {
      track.bumps.push_back(test::bump(DipShape::kHalfSine, 8e-3, 4.0, 3.0));
      track.bumps.back().rail = rail;
    }
    return railHeight(track, 5.0);
  };
  using enum RailSide;
  EXPECT_WITHIN(heightOf({kBoth}), 8e-3, kRounding);
  EXPECT_WITHIN(heightOf({kLeft, kRight}), 8e-3, kRounding);
  EXPECT_WITHIN(heightOf({kLeft}), 4e-3, kRounding);
  EXPECT_WITHIN(heightOf({kRight}), 4e-3, kRounding);
  Track track = extended();
  track.harmonics = {test::harmonic(25.0, 1.0, 5e-3)};
  track.ramps = {ramp(6e-3, 2.0, -10.0)};
  track.dips = {dip(DipShape::kHalfSine, 8e-3, 4.0, 4.25)};  // its middle at 6.25 m, where the harmonic peaks
  EXPECT_WITHIN(railHeight(track, 6.25), 5e-3 + 6e-3 - 8e-3, kRounding);
  track.harmonics[0].rail = kLeft;
  track.ramps[0].rail = kRight;
  track.dips[0].rail = kLeft;
  EXPECT_WITHIN(railHeight(track, 6.25), 0.5 * (5e-3 + 6e-3 - 8e-3), kRounding);
}

}  // namespace
}  // namespace vehicle
