// Metrics of modes: one name is one mode in every design, whatever it is called there.
#include "libvehicle/study/evaluate/mode_metrics.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/linear/modes.h"
#include "libvehicle/simulate/forms.h"
#include "libvehicle/study/study_warnings.h"
#include "tests/study/inputs.h"
#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

using namespace test;

constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// A short locomotive whose body pitches against strong dampers: it is overdamped on soft springs.
Vehicle shortPitchLoco() {
  return symmetricVehicle("short-pitch-loco", 57e3, 70e3, 3.7, {9e3, std::nullopt, 1.5}, element("primary", 3e6, 30e3),
                          element("secondary", 2.7e6, 100e3));
}

StudyInputs steadyInputs(Study study, const Vehicle& vehicle) {
  study.evaluation = Evaluation::kSteadyState;
  Scenario scenario = paperScenario(History::kExtended);
  scenario.track->harmonics = {harmonic(25.0, 1, 4e-3), harmonic(9.0, 1, 1e-3)};
  scenario.run.speed = 30.0;
  return inputsOf(std::move(study), vehicle, {scenario});
}

std::vector<Mode> modesOfDesign(const Vehicle& vehicle, const StudyInputs& inputs, const std::vector<double>& values) {
  Vehicle design = vehicle;
  std::vector<Scenario> scenarios = inputs.scenarios;
  apply(inputs.bound, values, design, scenarios);
  return modesOf(*buildForm("matrix", compile(design, 9.81)));
}

// The published case: 31 values of the secondary stiffness. Where carbody pitch is overdamped (at 0.6 MN/m its roots
// are 2 pi times -1.170 and -6.542 1/s) its frequency alone is missing; bounce there is 0.7112 Hz with a damping ratio
// of 0.337. The digits given are what is compared.
TEST(ModeMetrics, AModeThatStopsOscillatingLeavesTheDesignsOtherMetrics) {
  const Vehicle vehicle = shortPitchLoco();
  const StudyInputs inputs =
      steadyInputs(studyOf({range("secondary.stiffness_z", "200 kN/m", "6 MN/m")},
                           {"carbody.az.rms", "mode.carbody bounce.frequency", "mode.carbody bounce.damping",
                            "mode.carbody pitch.frequency", "mode.carbody pitch.damped_frequency",
                            "mode.carbody pitch.damping", "mode.carbody pitch.undamped_frequency"}),
                   vehicle);
  std::vector<std::vector<double>> designs = {{2.7e6}};
  for (int i = 1; i <= 30; ++i) designs.push_back({i * 200e3});
  const Answers answers = answersOf(inputs, designs);
  EXPECT_TRUE(answers.problems.empty());
  double before = 0.0;
  for (std::size_t i = 0; i < designs.size(); ++i) {
    const std::vector<double>& row = answers.metrics[i];
    for (const std::size_t whole : {0u, 1u, 2u, 5u, 6u}) EXPECT_GT(row[whole], 0.0) << i << " " << whole;
    const bool overdamped = i > 0 && designs[i][0] < 1.1e6;
    EXPECT_EQ(std::isnan(row[3]), overdamped) << i;
    EXPECT_EQ(row[5] > 1.0, overdamped) << i;
    EXPECT_EQ(answers.gaps.contains(static_cast<std::int64_t>(i)), overdamped);
    if (i == 0) continue;
    EXPECT_GT(row[1], before);  // a stiffer spring, a higher bounce
    before = row[1];
  }
  EXPECT_WITHIN(answers.metrics[3][1], 0.7112, 5e-5);
  EXPECT_WITHIN(answers.metrics[3][2], 0.337, 5e-4);
  EXPECT_WITHIN(answers.metrics[3][5], (1.170 + 6.542) / (2.0 * std::sqrt(1.170 * 6.542)), 5e-4);
  EXPECT_EQ(answers.gaps.at(3),
            "mode.carbody pitch.frequency, mode.carbody pitch.damped_frequency: the mode is overdamped: its roots are "
            "real, it does not oscillate");
}

// The symmetric vehicle's pitch and antiphase bounce: (J w^2 - 2 a^2 ks)(m w^2 - ks - 2 kp) = 2 a^2 ks^2 (m: one
// bogie).
TEST(ModeMetrics, ThreeFrequenciesOfAModeAreThoseOfItsRoot) {
  const Vehicle vehicle = shortPitchLoco();
  const StudyInputs inputs =
      steadyInputs(studyOf({range("secondary.damping_z", "0 N*s/m", "400 kN*s/m")},
                           {"mode.carbody bounce.frequency", "mode.carbody bounce.damped_frequency",
                            "mode.carbody bounce.undamped_frequency", "mode.carbody bounce.damping",
                            "mode.carbody pitch.undamped_frequency"}),
                   vehicle);
  const Answers answers = answersOf(inputs, {{100e3}, {0.0}, {60e3}});
  const double ks = 2.7e6, kp = 3e6, m = 9e3, carbody = 57e3, pitch = 70e3, a2 = 3.7 * 3.7;
  // Bounce: 57 t and both bogies, (M w^2 - 2 ks)(m w^2 - ks - 2 kp) = 2 ks^2.
  const auto lower = [&](double M, double K, double sign) {
    const double b = m * K + M * (ks + 2 * kp);
    const double c = K * (ks + 2 * kp) - K * ks;
    return std::sqrt((b + sign * std::sqrt(b * b - 4.0 * M * m * c)) / (2.0 * M * m)) / kTwoPi;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<double>& row = answers.metrics[i];
    // Of the two modes with pitch the higher one is the carbody's (docs/theory/errata.md).
    EXPECT_WITHIN(row[2], lower(carbody, 2 * ks, -1.0), 1e-12) << i;
    EXPECT_WITHIN(row[4], lower(pitch, 2 * a2 * ks, 1.0), 1e-11) << i;
    EXPECT_WITHIN(row[1], row[0] * std::sqrt(1.0 - row[3] * row[3]), 1e-12);
  }
  // Only primary dampers are left: the modes are damped still.
  EXPECT_GT(answers.metrics[1][3], 0.0);
}

// Every design by itself, in any company, order and number of threads.
TEST(ModeMetrics, ADesignsValuesDependOnBaseAndDesignAlone) {
  const Vehicle vehicle = bogiePitchVehicle();
  const StudyInputs inputs = steadyInputs(
      studyOf({range("secondary.damping_z", "0 N*s/m", "200 kN*s/m"), range("primary.stiffness_z", "1 MN/m", "4 MN/m"),
               range("carbody.pitch_inertia", "0.5 Gg*m^2", "4 Gg*m^2")},
              {"mode.carbody pitch.frequency", "mode.front_bogie + rear_bogie bounce in phase.damping"}),
      vehicle);
  std::vector<std::vector<double>> designs;
  for (int i = 0; i < 24; ++i) {
    designs.push_back({8e3 * i, 1e6 + 0.12e6 * ((7 * i) % 24), 0.5e6 + 0.14e6 * ((11 * i) % 24)});
  }
  const Answers together = answersOf(inputs, designs);
  const Answers shared = answersOf(inputs, designs, 3);
  const std::vector<std::vector<double>> reversed(designs.rbegin(), designs.rend());
  const Answers backwards = answersOf(inputs, reversed);
  const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  for (std::size_t i = 0; i < designs.size(); ++i) {
    const Answers alone = answersOf(inputs, {designs[i]});
    for (std::size_t m = 0; m < 2; ++m) {
      EXPECT_TRUE(same(together.metrics[i][m], alone.metrics[0][m])) << i;
      EXPECT_TRUE(same(shared.metrics[i][m], alone.metrics[0][m])) << i;
      EXPECT_TRUE(same(backwards.metrics[designs.size() - 1 - i][m], alone.metrics[0][m])) << i;
    }
  }
}

// Named by what moves, "carbody pitch" and "bounce" would be other roots in other designs. The value of a design is one
// of its own roots, and no two modes have the same.
TEST(ModeMetrics, EveryModeHasARootOfItsOwnInEveryDesign) {
  const Vehicle vehicle = shortPitchLoco();
  const std::vector<std::string> names = {"carbody bounce", "front_bogie + rear_bogie bounce in antiphase",
                                          "front_bogie + rear_bogie bounce in phase", "carbody pitch"};
  std::vector<std::string> metrics;
  for (const std::string& each : names) metrics.push_back("mode." + each + ".frequency");
  const StudyInputs inputs =
      steadyInputs(studyOf({range("secondary.stiffness_z", "1 MN/m", "20 MN/m")}, metrics), vehicle);
  std::vector<std::vector<double>> designs;
  for (int i = 0; i <= 40; ++i) designs.push_back({1.2e6 + i * 0.4e6});
  const Answers answers = answersOf(inputs, designs);
  EXPECT_TRUE(answers.gaps.empty());
  for (std::size_t i = 0; i < designs.size(); ++i) {
    std::vector<double> expected;
    for (const Mode& each : modesOfDesign(vehicle, inputs, designs[i])) expected.push_back(each.frequency);
    std::vector<double> found = answers.metrics[i];
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found.size(), expected.size());
    // Flat and matrix form: the rounding of either.
    for (std::size_t m = 0; m < found.size(); ++m) EXPECT_WITHIN(found[m], expected[m], 1e-11) << designs[i][0];
    for (std::size_t m = 0; m < found.size() && i > 0; ++m) {
      // A spring of 4/3 at most, of a mode that is damped by two thirds.
      EXPECT_WITHIN(answers.metrics[i][m] / answers.metrics[i - 1][m], 1.0, 0.2) << i;
    }
  }
}

TEST(ModeMetrics, AModeThatIsOverdampedInTheBaseIsNamedWithoutItsKindToo) {
  Vehicle vehicle = shortPitchLoco();
  named(vehicle.elements, "secondary").stiffness_z = 0.6e6;
  const std::vector<std::string> metrics = {"mode.carbody pitch.frequency", "mode.carbody pitch, aperiodic.frequency",
                                            "mode.carbody pitch, aperiodic (2).frequency"};
  const StudyInputs inputs =
      steadyInputs(studyOf({range("secondary.stiffness_z", "200 kN/m", "6 MN/m")}, metrics), vehicle);
  EXPECT_TRUE(warningsBefore(inputs).empty());
  const Answers answers = answersOf(inputs, {{0.6e6}, {2.7e6}});
  for (const double each : answers.metrics[0]) EXPECT_TRUE(std::isnan(each));
  for (const double each : answers.metrics[1]) EXPECT_WITHIN(each, 6.1619, 5e-5);  // `modes` of that vehicle
}

TEST(ModeMetrics, AnUnknownNameIsAWarningBeforeTheStudyAndEmptyInEveryDesign) {
  Study study = studyOf({range("carbody.mass", "40 t", "60 t")},
                        {"mode.carbody bouncy.frequency", "mode.nothing like it.damping", "static.wheelset_1.load"});
  for (StudyMetric& each : study.metrics) {
    each.origin.file = "study.xml";
    each.origin.line = 7;
  }
  const StudyInputs inputs = inputsOf(study, paperVehicle(), {paperScenario(History::kOnset)});
  const Warnings warnings = warningsBefore(inputs);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0].text(),
            "study.xml:7: warning: mode.carbody bouncy.frequency: mode \"carbody bouncy\" is unknown in the vehicle as "
            "its file says it: the metric has no value in any design; did you mean \"carbody bounce\"? [UNKNOWN_MODE]");
  EXPECT_NE(warnings[1].text().find("; choose one of carbody bounce, "), std::string::npos) << warnings[1].text();
  const Answers answers = answersOf(inputs, {{57e3}, {40e3}});
  EXPECT_TRUE(answers.problems.empty());
  for (const std::int64_t design : {0, 1}) {
    EXPECT_TRUE(answers.gaps.at(design).starts_with(
        "mode.carbody bouncy.frequency: mode \"carbody bouncy\" is unknown; did you mean \"carbody bounce\"? | "))
        << answers.gaps.at(design);
    EXPECT_GT(answers.metrics[static_cast<std::size_t>(design)][2], 0.0);
  }
}

// Preloads that balance the carbody, F1 x1 + F2 x2 = 0, at both ends of the line do not on it: no vehicle stands there.
TEST(ModeMetrics, WhereNoVehicleStandsBetweenBaseAndDesignTheMatricesLeadAcross) {
  Vehicle vehicle = shortPitchLoco();
  const double weight = 57e3 * 9.81;
  named(vehicle.suspensions, "secondary_front").preload = 0.5 * weight;
  named(vehicle.suspensions, "secondary_rear").preload = 0.5 * weight;
  const StudyInputs inputs =
      steadyInputs(studyOf({range("secondary_front.x", "3 m", "5 m"), range("secondary_rear.x", "-5 m", "-3 m"),
                            range("secondary_front.preload", "100 kN", "400 kN"),
                            range("secondary_rear.preload", "100 kN", "400 kN")},
                           {"mode.carbody bounce.frequency"}),
                   vehicle);
  const std::vector<double> design = {4.5, -3.0, 0.4 * weight, 0.6 * weight};
  const std::vector<double> halfway = {4.1, -3.35, 0.45 * weight, 0.55 * weight};
  EXPECT_THROW((void)modesOfDesign(vehicle, inputs, halfway), InvalidInput);
  const Answers answers = answersOf(inputs, {design, halfway});
  EXPECT_TRUE(answers.gaps.empty());
  EXPECT_WITHIN(answers.metrics[0][0], modesOfDesign(vehicle, inputs, design).front().frequency, 1e-12);
  EXPECT_TRUE(answers.problems.contains(1));
}

}  // namespace
}  // namespace vehicle
