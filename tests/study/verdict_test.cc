#include "libvehicle/study/compare/verdict.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/study/studies.h"

namespace vehicle {
namespace {

using Values = std::vector<double>;

/// Two speeds; columns: az @ 60, az @ 120, deflection @ 60, deflection @ 120, load.
BoundStudy twoSpeeds() {
  Study study =
      test::studyOf({test::range("carbody.mass", "50 t", "60 t", 2), test::range("speed", "60 km/h", "120 km/h", 2)});
  study.metrics = {{"carbody.az.rms", {}}, {"secondary_front.deflection.min", {}}, {"static.wheelset_1.load", {}}};
  study.objectives = {{"carbody.az.rms", Goal::kMinimise, Over::kWorst, {}},
                      {"secondary_front.deflection.min", Goal::kMaximise, Over::kWorst, {}},
                      {"static.wheelset_1.load", Goal::kMinimise, Over::kMean, {}}};
  study.limits = {{"carbody.az.rms", "0.5 m/s^2", "0.1 m/s^2", {}}, {"static.wheelset_1.load", "100 kN", "", {}}};
  return bindStudy(study, test::paperVehicle(), {test::waves()}).orThrow();
}

TEST(Verdict, TheWorstSpeedCountsInTheSenseOfTheGoal) {
  const Verdict verdict(twoSpeeds());
  const Values row = {0.3, 0.4, -0.02, -0.01, 90e3};
  EXPECT_EQ(verdict.objectives(row), (Values{0.4, -0.02, 90e3}));
  EXPECT_EQ(verdict.toMinimise(row), (Values{0.4, 0.02, 90e3}));
}

TEST(Verdict, ALimitIsOversteppedByItsWorstSpeed) {
  const Verdict verdict(twoSpeeds());
  EXPECT_TRUE(verdict.keepsLimits(Values{0.5, 0.1, 0.0, 0.0, 100e3}));
  const Values above = {0.75, 0.25, 0.0, 0.0, 101e3};
  EXPECT_EQ(verdict.violations(above), (Values{0.25, 1e3}));
  EXPECT_FALSE(verdict.keepsLimits(above));
  EXPECT_FALSE(verdict.keepsLimits(Values{0.2, 0.05, 0.0, 0.0, 0.0}));
}

// A value that is missing makes its objective missing and its limit not kept, and no other.
TEST(Verdict, WhatIsMissingIsNeitherGoodNorWithinALimit) {
  const Verdict verdict(twoSpeeds());
  const double none = std::nan("");
  const Values row = {none, 0.4, -0.02, -0.01, 90e3};
  const Values objectives = verdict.objectives(row);
  EXPECT_TRUE(std::isnan(objectives[0]));
  EXPECT_EQ(objectives[1], -0.02);
  EXPECT_EQ(verdict.violations(row), (Values{INFINITY, 0.0}));
  EXPECT_FALSE(verdict.keepsLimits(row));
  EXPECT_TRUE(std::isnan(verdict.objectives(Values{0.3, 0.4, -0.02, -0.01, none})[2]));  // of a mean
}

TEST(Verdict, NamesTheColumnOfTheWorstCase) {
  const BoundStudy study = twoSpeeds();
  const Verdict verdict(study);
  const Values row = {0.3, 0.4, -0.02, -0.01, 90e3};
  EXPECT_EQ(verdict.worstColumn(study.objectives[0], row), 1u);
  EXPECT_EQ(verdict.worstColumn(study.objectives[1], row), 2u);
  EXPECT_EQ(verdict.worstColumn(study.objectives[0], Values{0.4, 0.4, 0.0, 0.0, 0.0}), 0u);  // equal: the first
  EXPECT_EQ(verdict.worstColumn(study.objectives[0], Values{std::nan(""), 0.4, 0.0, 0.0, 0.0}), std::nullopt);
}

}  // namespace
}  // namespace vehicle
