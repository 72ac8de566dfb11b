// Where designs of a study leave what the model can say. Motions are linear in the rail's height: from one run the height
// follows at which a load reaches 0 or a motion its bound, and the warning must begin there on every path.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/study/study_warnings.h"
#include "tests/study/inputs.h"

namespace vehicle {
namespace {

using namespace test;

struct PathCase {
  std::string name;
  Vehicle vehicle;
  Evaluation evaluation;
  PathChoice::Kind path;
};

std::vector<PathCase> allPaths() {
  using enum PathChoice::Kind;
  return {{"steady lanes", paperVehicle(), Evaluation::kSteadyState, kSteadyEnsemble},
          {"steady, one by one", bogiePitchVehicle(), Evaluation::kSteadyState, kSteadySingle},
          {"lanes in time", paperVehicle(), Evaluation::kRun, kEnsembleRuns},
          {"runs one by one", bogiePitchVehicle(), Evaluation::kRun, kSingleRuns}};
}

/// Three harmonics of one period whose crests do not meet: bounds by sums of amplitudes are too large.
Scenario wavyScenario(double height) {
  Scenario scenario = paperScenario(History::kExtended);
  scenario.run.duration = 5.0;
  scenario.track->harmonics = {harmonic(25.0, 1, 5e-3 * height), harmonic(25.0, 3, 2e-3 * height),
                               harmonic(25.0, 7, 1e-3 * height)};
  return scenario;
}

Answers answersOver(const PathCase& way, const std::string& metric, double height,
                    const std::vector<std::vector<double>>& designs) {
  Study study = studyOf({range("carbody.mass", "30 t", "60 t")}, {metric, "carbody.az.rms"});
  study.evaluation = way.evaluation;
  const StudyInputs inputs = inputsOf(study, way.vehicle, {wavyScenario(height)});
  EXPECT_EQ(choosePath(inputs).kind, way.path) << way.name;
  return answersOf(inputs, designs);
}

TEST(StudyWarnings, AWheelLoadBelowZeroIsSaidFromTheVeryHeightOnByEveryPath) {
  for (const PathCase& way : allPaths()) {
    // The wheelset that is unloaded most decides.
    double critical = HUGE_VAL;
    for (const char* wheelset : {"wheelset_1", "wheelset_2", "wheelset_3", "wheelset_4"}) {
      const std::string load = std::string(wheelset) + ".load.min";
      const double at_rest = answersOver(way, load, 1e-9, {{50e3}}).metrics[0][0];
      const double moving = answersOver(way, load, 1.0, {{50e3}}).metrics[0][0];
      critical = std::min(critical, at_rest / (at_rest - moving));
    }
    // Peaks are found to 1e-4 of the motion (sampling and parabola); motions beyond 0.5 m or 0.1 rad do not come up.
    EXPECT_TRUE(answersOver(way, "carbody.z.rms", 0.998 * critical, {{50e3}}).warnings.empty()) << way.name;
    const Answers beyond = answersOver(way, "carbody.z.rms", 1.002 * critical, {{50e3}});
    EXPECT_EQ(beyond.warnings, (std::map<std::int64_t, std::string>{{0, "WHEEL_LOAD"}})) << way.name;
    EXPECT_TRUE(beyond.problems.empty());
  }
}

TEST(StudyWarnings, AMotionBeyondLinearKinematicsIsSaidFromTheVeryHeightOnByEveryPath) {
  for (PathCase way : allPaths()) {
    // Without weight no load is asked for, and suspensions move by half a metre before a body pitches by 0.1 rad.
    const auto heightOf = [&](const std::string& metric, double most) {
      return most / answersOver(way, metric, 1.0, {{50e3}}).metrics[0][0];
    };
    double critical = heightOf("carbody.pitch.peak", 0.1);
    for (const Suspension& each : way.vehicle.suspensions) {
      critical = std::min(critical, heightOf(each.name + ".deflection.peak", 0.5));
    }
    for (const Body& each : way.vehicle.bodies) {
      if (each.name != "carbody" && each.motion.size() == 2) {
        critical = std::min(critical, heightOf(each.name + ".pitch.peak", 0.1));
      }
    }
    const std::string below = answersOver(way, "carbody.z.rms", 0.998 * critical, {{50e3}}).warnings[0];
    const std::string beyond = answersOver(way, "carbody.z.rms", 1.002 * critical, {{50e3}}).warnings[0];
    EXPECT_EQ(below.find("LARGE_MOTION"), std::string::npos) << way.name << below;
    EXPECT_NE(beyond.find("LARGE_MOTION"), std::string::npos) << way.name << beyond;
  }
}

// 100 t on two springs of 1 MN/m come down by 0.49 m, on softer ones by more.
TEST(StudyWarnings, ASpringThatComesDownTooFarIsSaidOfThatDesignAlone) {
  for (PathCase way : allPaths()) {
    Study study = studyOf({range("secondary.stiffness_z", "100 kN/m", "2 MN/m")}, {"carbody.az.rms"});
    study.evaluation = way.evaluation;
    for (Body& each : way.vehicle.bodies) {
      if (each.name == "carbody") each.mass = 100e3;
    }
    const StudyInputs inputs = inputsOf(study, way.vehicle, {wavyScenario(1.0)});
    ASSERT_EQ(choosePath(inputs).kind, way.path);
    const double sharp = 100e3 * inputs.scenarios[0].gravity / 2.0 / 0.5;
    const Answers answers = answersOf(inputs, {{2e6}, {0.999 * sharp}, {1.001 * sharp}});
    EXPECT_EQ(answers.warnings, (std::map<std::int64_t, std::string>{{1, "REST_DEFLECTION"}})) << way.name;
  }
}

// Loads that a file gives are those of the base; a design of another mass has another weight.
TEST(StudyWarnings, GivenLoadsThatMissTheWeightOfADesignAreSaidOfIt) {
  for (PathCase way : allPaths()) {
    Study study = studyOf({range("carbody.mass", "30 t", "60 t")}, {"carbody.az.rms"});
    study.evaluation = way.evaluation;
    const Scenario scenario = wavyScenario(1.0);
    double mass = 0.0;
    for (const Body& each : way.vehicle.bodies) mass += each.mass;
    for (const Wheelset& each : way.vehicle.wheelsets) mass += each.mass.value_or(0.0);
    const double weight = mass * scenario.gravity;
    for (Wheelset& each : way.vehicle.wheelsets) {
      each.load = weight / static_cast<double>(way.vehicle.wheelsets.size());
    }
    double carbody = 0.0;
    for (const Body& each : way.vehicle.bodies) carbody += each.name == "carbody" ? each.mass : 0.0;
    const StudyInputs inputs = inputsOf(study, way.vehicle, {scenario});
    const Answers answers = answersOf(inputs, {{carbody}, {carbody + 0.0049 * mass}, {carbody + 0.0052 * mass}});
    EXPECT_EQ(answers.warnings, (std::map<std::int64_t, std::string>{{2, "GIVEN_LOADS"}})) << way.name;
  }
}

}  // namespace
}  // namespace vehicle
