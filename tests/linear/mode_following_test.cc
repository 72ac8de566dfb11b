#include "libvehicle/linear/mode_following.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "libvehicle/linear/undamped.h"
#include "tests/linear/coach.h"
#include "tests/support/tolerance.h"

namespace vehicle::test {
namespace {

using Complex = std::complex<double>;
using Fate = FollowedMode::Fate;
using Eigen::Matrix2d;

/// The one mode of that name, from a base to the end of a path.
FollowedMode followed(const ModeFollower& follower, const MatrixPath& path, const std::string& name) {
  return follower.follow(path).at(follower.find(name).value());
}

Complex valueOf(const FollowedMode& mode) { return mode.roots.at(0).eigenvalue; }

/// Two unit masses a and b on their own springs, joined by another.
Eigen::MatrixXd twoMasses(double ka, double kb, double joined, double damping = 0.02) {
  const Matrix2d K{{ka + joined, -joined}, {-joined, kb + joined}};
  return stateMatrix(Matrix2d::Identity(), damping * Matrix2d::Identity(), K);
}
const std::vector<Channel> kTwo = statesOf({"a.z", "b.z"});

/// Undamped angular frequencies of the same, the lower one first.
std::pair<double, double> frequenciesOf(double ka, double kb, double joined) {
  const double mean = 0.5 * (ka + kb) + joined;
  const double half = std::hypot(0.5 * (ka - kb), joined);
  return {std::sqrt(mean - half), std::sqrt(mean + half)};
}

TEST(ModeFollowing, UncoupledModesPassEachOtherAndKeepTheirNames) {
  const ModeFollower follower(twoMasses(1.0, 4.0, 0.0), kTwo);
  for (const double end : {0.5, 3.999999, 4.0, 4.000001, 9.0, 100.0}) {
    const auto path = [&](double t) { return twoMasses(1.0 + t * (end - 1.0), 4.0, 0.0); };
    // Equal dampings: |lambda| is the undamped frequency, to the rounding of an eigenvalue of size 10. Roots that
    // coincide within 1e-6 are not distinguished.
    const double rounding = std::abs(end - 4.0) < 1e-5 ? 4e-7 : 1e-14;
    EXPECT_WITHIN(std::abs(valueOf(followed(follower, path, "a bounce"))), std::sqrt(end), rounding) << end;
    EXPECT_WITHIN(std::abs(valueOf(followed(follower, path, "b bounce"))), 2.0, rounding) << end;
  }
}

// Frequencies of coupled masses never meet: the lower one stays the lower one, however weak the coupling, and its shape
// passes from one mass to the other.
TEST(ModeFollowing, CoupledModesKeepTheirBranchThroughVeering) {
  for (const double joined : {1e-5, 1e-4, 1e-3, 0.01, 0.1, 0.5}) {
    const ModeFollower follower(twoMasses(1.0, 2.0, joined), kTwo);
    double before = 0.0;
    for (int i = 0; i <= 60; ++i) {
      const double end = 1.0 + i / 20.0;  // through the middle of the veering at 2
      const auto path = [&](double t) { return twoMasses(1.0 + t * (end - 1.0), 2.0, joined); };
      const std::vector<FollowedMode> modes = follower.follow(path);
      const auto [low, high] = frequenciesOf(end, 2.0, joined);
      ASSERT_EQ(modes.size(), 2u);
      EXPECT_WITHIN(std::abs(valueOf(modes[0])), low, 1e-13) << joined << " " << end;
      EXPECT_WITHIN(std::abs(valueOf(modes[1])), high, 1e-13) << joined << " " << end;
      EXPECT_GE(std::abs(valueOf(modes[0])), before - 1e-13);
      before = std::abs(valueOf(modes[0]));
    }
    EXPECT_TRUE(follower.modes()[0].names.front().starts_with("a ")) << follower.modes()[0].names.front();
  }
}

TEST(ModeFollowing, ACouplingThatNoSweepCouldSeeIsNone) {
  const ModeFollower follower(twoMasses(1.0, 2.0, 1e-7), kTwo);
  for (const double end : {1.9, 2.1, 3.0}) {
    const auto path = [&](double t) { return twoMasses(1.0 + t * (end - 1.0), 2.0, 1e-7); };
    EXPECT_WITHIN(std::abs(valueOf(followed(follower, path, "a bounce"))), std::sqrt(end), 1e-7) << end;
  }
}

/// One mass of w = 10 1/s: lambda^2 + 2 zeta w lambda + w^2 = 0.
Eigen::MatrixXd oscillator(double zeta) { return Matrix2d{{0.0, 1.0}, {-100.0, -20.0 * zeta}}; }

TEST(ModeFollowing, ThroughCriticalDampingAndBackItIsOneMode) {
  const std::vector<Channel> states = statesOf({"carbody.pitch"});
  for (const double from : {0.0, 0.3, 0.999, 1.0, 1.001, 3.0}) {
    const ModeFollower follower(oscillator(from), states);
    ASSERT_EQ(follower.modes().size(), 1u) << from;
    EXPECT_EQ(follower.modes()[0].names.front(), "carbody pitch");
    for (const double to : {0.0, 0.5, 0.9999, 1.0, 1.0001, 2.0, 50.0}) {
      const FollowedMode mode = followed(
          follower, [&](double t) { return oscillator((1.0 - t) * from + t * to); }, "carbody pitch");
      EXPECT_EQ(mode.fate, to < 1.0 ? Fate::kOscillates : Fate::kAperiodic) << from << " " << to;
      // A double root splits by the square root of the rounding, and so does what is read from its halves.
      const double rounding = std::abs(to - 1.0) < 0.01 ? 1e-7 : 1e-12;
      EXPECT_WITHIN(mode.dampingRatio().value(), to, rounding * std::max(1.0, to * to)) << from << " " << to;
      EXPECT_EQ(mode.frequency().has_value(), to < 1.0);
      if (to < 1.0) {
        EXPECT_WITHIN(mode.frequency().value(), 10.0 / (2.0 * std::numbers::pi), rounding);
        EXPECT_WITHIN(mode.dampedFrequency().value(), 10.0 * std::sqrt(1.0 - to * to) / (2.0 * std::numbers::pi),
                      to > 0.99 ? 1e-6 : 1e-12);
        EXPECT_EQ(mode.whyNoFrequency(), "");
      } else {
        EXPECT_EQ(mode.whyNoFrequency(), "the mode is overdamped: its roots are real, it does not oscillate");
      }
    }
  }
}

TEST(ModeFollowing, AWayThatLeadsOverCriticalDampingComesBackToTheSameMode) {
  // Two modes that both are overdamped halfway; each has to find its own two roots again.
  const auto path = [](double t) {
    const double zeta = 0.2 + 8.0 * t * (1.0 - t);
    const Matrix2d C = Eigen::Vector2d(2.0 * zeta, 2.0 * 3.0 * zeta).asDiagonal();
    const Matrix2d K = Eigen::Vector2d(1.0, 9.0).asDiagonal();
    return stateMatrix(Matrix2d::Identity(), C, K);
  };
  const ModeFollower follower(path(0.0), kTwo);
  const double half = 0.5;
  const std::vector<std::vector<FollowedMode>> halfway = follower.follow(path, std::span(&half, 1));
  for (const FollowedMode& each : halfway.front()) {
    EXPECT_EQ(each.fate, Fate::kAperiodic);
    EXPECT_WITHIN(each.dampingRatio().value(), 2.2, 1e-12);
  }
  EXPECT_WITHIN(std::abs(valueOf(followed(follower, path, "a bounce"))), 1.0, 1e-14);
  EXPECT_WITHIN(std::abs(valueOf(followed(follower, path, "b bounce"))), 3.0, 1e-14);
}

TEST(ModeFollowing, AnOverdampedModeOfTheBaseIsNamedWithAndWithoutItsKind) {
  // Both overdamped, and the slow root of b lies between those of a: size alone would pair them wrongly.
  const auto matrix = [](double share) {
    const Matrix2d C = Eigen::Vector2d(share * 10.0, share * 15.0).asDiagonal();
    return stateMatrix(Matrix2d::Identity(), C, Eigen::Vector2d(4.0, 36.0).asDiagonal());
  };
  const ModeFollower follower(matrix(1.0), kTwo);
  ASSERT_EQ(follower.modes().size(), 2u);
  EXPECT_EQ(follower.modes()[0].names,
            (std::vector<std::string>{"a bounce", "a bounce, aperiodic", "a bounce, aperiodic (2)"}));
  for (const char* name : {"a bounce", "a bounce, aperiodic", "a bounce, aperiodic (2)"}) {
    EXPECT_EQ(follower.find(name), 0u);
  }
  EXPECT_EQ(follower.find("b bounce"), 1u);
  EXPECT_EQ(follower.find("c bounce"), std::nullopt);
  const auto path = [&](double t) { return matrix(1.0 - 0.9 * t); };
  EXPECT_WITHIN(std::abs(valueOf(followed(follower, path, "a bounce, aperiodic (2)"))), 2.0, 1e-14);
  EXPECT_WITHIN(std::abs(valueOf(followed(follower, path, "b bounce"))), 6.0, 1e-14);
}

// Bogies pitch by themselves on w = a sqrt(2 k / J), zeta = a^2 c / (J w) (modes_test.cc): those of the base coincide.
TEST(ModeFollowing, EqualBogiesPartByTheirShapes) {
  const ModeFollower follower(coachMatrix(), coachStates());
  const auto pitch = [](double stiffness) { return std::sqrt(2 * 1.28 * 1.28 * stiffness / 1476); };
  for (const int changed : {0, 1}) {
    for (const double share : {0.2, 1.0 - 1e-9, 1.0 + 1e-5, 3.0}) {
      const auto path = [&](double t) {
        CoachNumbers numbers;
        numbers.primary_stiffness[changed] *= 1.0 + t * (share - 1.0);
        return coachMatrix(numbers);
      };
      const double front = pitch(2440e3 * (changed == 0 ? share : 1.0));
      const double rear = pitch(2440e3 * (changed == 1 ? share : 1.0));
      // Roots that coincide within 1e-6 are not distinguished.
      const double rounding = std::abs(share - 1.0) < 1e-6 ? 1e-7 : 1e-12;
      EXPECT_WITHIN(std::abs(valueOf(followed(follower, path, "front_bogie pitch"))), front, rounding) << share;
      EXPECT_WITHIN(std::abs(valueOf(followed(follower, path, "rear_bogie pitch"))), rear, rounding) << share;
    }
  }
}

TEST(ModeFollowing, EqualBogiesAreOverdampedTogetherAndEachKeepsBothItsRoots) {
  const ModeFollower follower(coachMatrix(), coachStates());
  const auto damped = [](double share) {
    return [share](double t) {
      CoachNumbers numbers;
      numbers.primary_damping *= 1.0 + t * (share - 1.0);
      return coachMatrix(numbers);
    };
  };
  const double w = std::sqrt(2 * 1.28 * 1.28 * 2440e3 / 1476), zeta = 1.28 * 1.28 * 8e3 / (1476 * w);
  for (const double share : {0.5, 0.9 / zeta, 1.1 / zeta, 3.0 / zeta}) {
    for (const char* name : {"front_bogie pitch", "rear_bogie pitch"}) {
      const FollowedMode mode = followed(follower, damped(share), name);
      EXPECT_EQ(mode.fate, share * zeta < 1.0 ? Fate::kOscillates : Fate::kAperiodic) << share;
      EXPECT_WITHIN(mode.dampingRatio().value(), share * zeta, 1e-10) << name << share;
    }
  }
}

// Secondary dampers from none to five times their size split the bogies' bounce into real roots on the way. Every
// value of a mode lies beside that of the neighbouring design, though each is followed from the base alone; and
// together the modes have all the roots.
TEST(ModeFollowing, TwoHundredDampersOfACoachMakeUnbrokenCurves) {
  const ModeFollower follower(coachMatrix(), coachStates());
  std::vector<FollowedMode> before;
  int aperiodic = 0;
  for (int i = 0; i <= 200; ++i) {
    const double share = 5.0 * i / 200.0;
    const auto path = [&](double t) {
      CoachNumbers numbers;
      numbers.secondary_damping *= 1.0 + t * (share - 1.0);
      return coachMatrix(numbers);
    };
    const std::vector<FollowedMode> modes = follower.follow(path);
    Complex sum = 0.0;
    for (std::size_t m = 0; m < modes.size(); ++m) {
      ASSERT_NE(modes[m].fate, Fate::kLost) << share << " " << follower.modes()[m].names.front();
      aperiodic += modes[m].fate == Fate::kAperiodic ? 1 : 0;
      for (const Mode& root : modes[m].roots) {
        sum += root.eigenvalue.imag() > 0.0 ? 2.0 * root.eigenvalue.real() : root.eigenvalue;
      }
      // Size and middle of the two roots pass critical damping smoothly, a frequency would not. The dampers' share
      // grows by 2.5 %: no curve moves by more than a tenth of its size.
      const Complex first = modes[m].roots.front().eigenvalue;
      const Complex second = modes[m].fate == Fate::kOscillates ? std::conj(first) : modes[m].roots.back().eigenvalue;
      if (!before.empty()) {
        const Complex was = before[m].roots.front().eigenvalue;
        const Complex was_second =
            before[m].fate == Fate::kOscillates ? std::conj(was) : before[m].roots.back().eigenvalue;
        const double size = std::abs(first) + std::abs(second);
        EXPECT_WITHIN(std::abs(first + second - was - was_second), 0.0, 0.1 * size) << share;
        EXPECT_WITHIN(std::abs(first * second - was * was_second), 0.0, 0.1 * size * size) << share;
      }
    }
    EXPECT_WITHIN(sum.real(), path(1.0).trace(), 1e-9) << share;  // rounding of roots of 74 1/s
    before = modes;
  }
  EXPECT_GT(aperiodic, 0);
}

// K = [1 s; -s 2] (a follower force): w^2 = 1.5 +- sqrt(0.25 - s^2); at s = 0.5 two frequencies meet in one with one
// shape, and beyond it one of the two pairs grows.
TEST(ModeFollowing, ModesThatMeetInOneShapeAreLostWithTheReason) {
  const auto matrix = [](double s) {
    return stateMatrix(Matrix2d::Identity(), Matrix2d::Zero(), Matrix2d{{1.0, s}, {-s, 2.0}});
  };
  const ModeFollower follower(matrix(0.1), kTwo);
  const auto upTo = [&](double end) { return [&, end](double t) { return matrix(0.1 + t * (end - 0.1)); }; };
  const double w2 = 1.5 - std::sqrt(0.25 - 0.49 * 0.49);
  EXPECT_WITHIN(std::abs(valueOf(followed(follower, upTo(0.49), "a bounce"))), std::sqrt(w2), 1e-13);
  const FollowedMode lost = followed(follower, upTo(0.6), "a bounce");
  EXPECT_EQ(lost.fate, Fate::kLost);
  EXPECT_TRUE(lost.roots.empty());
  EXPECT_EQ(lost.reason, "its roots meet in one point those of b bounce");
  EXPECT_EQ(lost.whyNoFrequency(), "the mode is lost on the way from the base: " + lost.reason);
  EXPECT_FALSE(lost.frequency() || lost.dampedFrequency() || lost.dampingRatio());
}

TEST(ModeFollowing, ARealRootThatJoinsOneOfAnotherModeIsNoLongerOneMode) {
  // (l + 1)(l + 3)(l + 3.2)(l + 6) = s^2: a with its two left factors, b with its two right ones. Between the inner
  // roots the product is at most 0.061, so from s = 0.25 on they are a pair.
  const auto matrix = [](double s) {
    return stateMatrix(Matrix2d::Identity(), Eigen::Vector2d(4.0, 9.2).asDiagonal(),
                       Matrix2d{{3.0, s}, {s, 3.2 * 6.0}});
  };
  const ModeFollower follower(matrix(0.0), kTwo);
  const std::vector<FollowedMode> apart = follower.follow([&](double t) { return matrix(0.2 * t); });
  for (const FollowedMode& each : apart) EXPECT_EQ(each.fate, Fate::kAperiodic);
  const std::vector<FollowedMode> joined = follower.follow([&](double t) { return matrix(0.3 * t); });
  EXPECT_EQ(joined[0].fate, Fate::kLost);
  EXPECT_EQ(joined[0].reason, "one of its two real roots has become an oscillation with one of b bounce");
  EXPECT_EQ(joined[1].reason, "one of its two real roots has become an oscillation with one of a bounce");
  // And where they part again, both modes have two real roots as before.
  const std::vector<FollowedMode> again = follower.follow([&](double t) { return matrix(0.8 * t * (1.0 - 0.9 * t)); });
  for (std::size_t m = 0; m < 2; ++m) {
    EXPECT_EQ(again[m].fate, Fate::kAperiodic);
    EXPECT_EQ(again[m].roots.size(), 2u);
  }
}

TEST(ModeFollowing, WhatNothingHoldsAndWhatTipsOverSaySo) {
  const auto matrix = [](double k) { return Matrix2d{{0.0, 1.0}, {-k, -0.1}}; };
  const ModeFollower follower(matrix(4.0), statesOf({"carbody.pitch"}));
  const FollowedMode tips = followed(
      follower, [&](double t) { return matrix(4.0 - 8.0 * t); }, "carbody pitch");
  EXPECT_EQ(tips.fate, Fate::kAperiodic);
  EXPECT_EQ(tips.whyNoFrequency(), "the mode grows without oscillating: its roots are real");
  EXPECT_FALSE(tips.dampingRatio());
  const FollowedMode free = followed(
      follower, [&](double t) { return matrix(4.0 - 4.0 * t); }, "carbody pitch");
  EXPECT_EQ(free.whyNoFrequency(), "the mode is free: nothing holds it, it does not oscillate");

  // And from a free base: the double zero has one shape.
  const ModeFollower unheld(Matrix2d{{0.0, 1.0}, {0.0, 0.0}}, statesOf({"carbody.z"}));
  const FollowedMode held = followed(
      unheld,
      [](double t) {
        return Matrix2d{{0.0, 1.0}, {-9.0 * t, 0.0}};
      },
      "carbody bounce");
  EXPECT_WITHIN(std::abs(valueOf(held)), 3.0, 1e-13);
}

TEST(ModeFollowing, DoesNotDependOnTheUnitsOfTheState) {
  // Milliradians beside metres.
  Eigen::VectorXd units(12);
  units << 1.0, 1e3, 1.0, 1e3, 1.0, 1e3, 1.0, 1e3, 1.0, 1e3, 1.0, 1e3;
  const auto path = [](double t) {
    CoachNumbers numbers;
    numbers.secondary_damping *= 1.0 + 7.0 * t;
    numbers.primary_stiffness[0] *= 1.0 + 0.3 * t;
    return coachMatrix(numbers);
  };
  const auto scaled = [&](double t) -> Eigen::MatrixXd {
    return units.asDiagonal() * path(t) * units.cwiseInverse().asDiagonal();
  };
  const std::vector<FollowedMode> one = ModeFollower(path(0.0), coachStates()).follow(path);
  const std::vector<FollowedMode> other = ModeFollower(scaled(0.0), coachStates()).follow(scaled);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t m = 0; m < one.size(); ++m) {
    EXPECT_EQ(one[m].fate, other[m].fate);
    EXPECT_WITHIN(std::abs(valueOf(one[m]) - valueOf(other[m])), 0.0, 1e-8);  // rounding, units a thousand apart
  }
}

TEST(ModeFollowing, StopsAreThoseOfOneWayAndMustRise) {
  const auto path = [](double t) { return oscillator(0.1 + t); };
  const ModeFollower follower(path(0.0), statesOf({"carbody.z"}));
  const std::vector<double> stops = {0.25, 0.5, 1.0};
  const auto ends = follower.follow(path, stops);
  ASSERT_EQ(ends.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_WITHIN(ends[i][0].dampingRatio().value(), 0.1 + stops[i], 1e-12);
  }
  const std::vector<double> falling = {0.5, 0.25};
  EXPECT_THROW((void)follower.follow(path, falling), std::invalid_argument);
}

TEST(UndampedModes, AreThoseOfMassesAndStiffnessesWhateverTheDamping) {
  const std::vector<UndampedMode> light = undampedModesOf(coachMatrix(), coachStates());
  for (const double share : {0.0, 1.0, 5.0, 40.0}) {
    CoachNumbers numbers;
    numbers.secondary_damping *= share;
    const Eigen::MatrixXd A = coachMatrix(numbers);
    const std::vector<UndampedMode> undamped = undampedModesOf(A, coachStates());
    ASSERT_EQ(undamped.size(), 6u);
    for (std::size_t m = 0; m < 6; ++m) EXPECT_EQ(undamped[m].frequency, light[m].frequency);
    const ModeFollower follower(A, coachStates());
    for (const WholeMode& whole : follower.modes()) {
      EXPECT_TRUE(undampedFrequencyOf(whole.roots, undamped).has_value()) << share << " " << whole.names.front();
    }
  }
  // The carbody's bounce with massless bogies: springs in series, k = 2 ks 4 kp / (2 ks + 4 kp); their 5 t move it by 1
  // %.
  const double series = 2.0 * 860e3 * 4.0 * 2440e3 / (2.0 * 860e3 + 4.0 * 2440e3);
  EXPECT_WITHIN(light[0].frequency / (std::sqrt(series / 32e3) / (2.0 * std::numbers::pi)), 1.0, 0.01);
}

TEST(UndampedModes, OfOneMassStandBesideBothRealRoots) {
  for (const double zeta : {0.0, 0.5, 1.0, 3.0}) {
    const std::vector<Channel> states = statesOf({"carbody.z"});
    const std::vector<UndampedMode> undamped = undampedModesOf(oscillator(zeta), states);
    for (const Mode& each : modesOf(oscillator(zeta), states)) {
      EXPECT_WITHIN(undampedFrequencyOf(std::span(&each, 1), undamped).value(), 10.0 / (2.0 * std::numbers::pi), 1e-14);
    }
  }
}

}  // namespace
}  // namespace vehicle::test
