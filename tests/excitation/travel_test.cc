#include "libvehicle/excitation/travel.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

using test::refusalOf;
using Phases = std::vector<Travel::Phase>;

TEST(Travel, AtConstantSpeedIsSpeedTimesTimeRoundedOnce) {
  const Travel travel(20.0);
  EXPECT_TRUE(travel.isUniform());
  EXPECT_EQ(travel.distance(3.7, 17.3), std::fma(20.0, 3.7, -17.3));
  EXPECT_EQ(travel.distance(-1.0), -20.0);
  EXPECT_EQ(travel.time(74.0), 74.0 / 20.0);
  EXPECT_EQ(travel.speed(100.0), 20.0);
  EXPECT_EQ(travel.acceleration(100.0), 0.0);
  EXPECT_EQ(travel.fastest(), 20.0);
  EXPECT_TRUE(travel.jumps().empty());
}

/// 10 s from 20 m/s at 1.5 m/s^2, 4 s on at 35 m/s, then braked at 2.5 m/s^2 to a stop, 14 s later.
const Phases kPhases = {{10.0, 1.5}, {4.0, 0.0}, {14.0, -2.5}};

// s = v t + a t^2 / 2 of each phase behind the one before: 275 m, 415 m, 660 m. Rounding of a few numbers of that size.
TEST(Travel, SpeedsUpRunsOnAndBrakesToAStop) {
  const Travel travel(20.0, kPhases);
  EXPECT_FALSE(travel.isUniform());
  EXPECT_WITHIN(travel.distance(4.0), 20.0 * 4.0 + 0.75 * 16.0, 1e-13);
  EXPECT_WITHIN(travel.distance(10.0), 275.0, 1e-13);
  EXPECT_WITHIN(travel.distance(12.0, 17.0), 275.0 + 35.0 * 2.0 - 17.0, 1e-13);
  EXPECT_WITHIN(travel.distance(20.0), 415.0 + 35.0 * 6.0 - 1.25 * 36.0, 1e-12);
  EXPECT_WITHIN(travel.distance(28.0), 660.0, 1e-12);
  EXPECT_EQ(travel.distance(1000.0), travel.distance(28.0));
  EXPECT_EQ(travel.distance(-2.0), -40.0);  // it ran before
  EXPECT_EQ(travel.speed(-2.0), 20.0);
  EXPECT_EQ(travel.speed(4.0), 26.0);
  EXPECT_EQ(travel.speed(20.0), 20.0);
  EXPECT_EQ(travel.speed(30.0), 0.0);
  EXPECT_EQ(travel.acceleration(-1.0), 0.0);
  EXPECT_EQ(travel.acceleration(10.0), 0.0);  // of what begins there
  EXPECT_EQ(travel.acceleration(14.0), -2.5);
  EXPECT_EQ(travel.acceleration(28.0), 0.0);
  EXPECT_EQ(travel.fastest(), 35.0);
  EXPECT_EQ(travel.jumps(), (std::vector<double>{10.0, 14.0, 28.0}));
}

// Near the stop a nanometre takes sqrt(2 1e-9 / 2.5) = 28 microseconds: there the place that the time leads to is compared.
TEST(Travel, TimeIsTheInverseOfDistance) {
  const Travel travel(20.0, kPhases);
  for (double s = -100.0; s < 659.9; s += 0.7) {
    EXPECT_WITHIN(travel.distance(travel.time(s)), s, 1e-11) << s;
  }
  EXPECT_WITHIN(travel.time(100.0), (-20.0 + std::sqrt(400.0 + 300.0)) / 1.5, 1e-14);
  EXPECT_EQ(travel.time(660.1), std::numeric_limits<double>::infinity());
  EXPECT_LT(travel.time(-3.0), 0.0);
}

TEST(Travel, RefusesWhatNeverStartsOrRunsBackwards) {
  EXPECT_EQ(refusalOf([] { Travel travel(0.0); }), "travel: speed = 0 m/s, must be finite and > 0");
  EXPECT_EQ(refusalOf([] {
              Travel travel(10.0, Phases{{5.0, -2.5}});
            }),
            "travel: -2.5 m/s^2 for 5 s from 10 m/s on; must last longer than 0 s and end at 0 m/s or more");
  EXPECT_EQ(refusalOf([] {
              Travel travel(10.0, Phases{{0.0, 1.0}});
            }),
            "travel: 1 m/s^2 for 0 s from 10 m/s on; must last longer than 0 s and end at 0 m/s or more");
}

}  // namespace
}  // namespace vehicle
