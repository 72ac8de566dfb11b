// Peaks and means of a run are those of its motion, not of its output samples.

#include <cmath>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "tests/simulate/histories.h"
#include "tests/support/refusal.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

Dip bump(double height, double length, double start) {
  Dip made;
  made.depth = -height;
  made.length = length;
  made.start = start;
  return made;
}

/// Over a bump of 10 mm and 3 m at 80 km/h, which sets the wheels on their contact springs swinging at 200 Hz.
Scenario bumpScenario(double output_step) {
  Scenario made = paperScenario(History::kOnset);
  made.track->harmonics.clear();
  made.track->dips = {bump(10e-3, 3.0, 10.0)};
  made.run.speed = 80.0 / 3.6;
  made.run.duration = 2.0;
  made.run.output_step = output_step;
  return made;
}

const ColumnSummary& summaryOf(const RunResult& result, const std::string& column) {
  return result.summaries.at(result.history.indexOf(column) - 1);
}

// Allowed: peaks 1e-3 of the peak (parabolas through 20 samples a period reach 2e-4). Means in closed form by exact: 1e-9
// for the rounding of other steps; else 1e-3, of which rk4 needs a third: steps follow the output step, and the longest that
// resolves the contact's mode loses up to a twentieth of it while it lasts.
// The samples themselves miss a quarter of the wheel load's dynamic part.
TEST(Measurement, DoesNotDependOnTheOutputStep) {
  const Vehicle vehicle = contactVehicle();
  for (const char* method : {"exact", "rk4", "dopri5"}) {
    const RunResult fine = run(vehicle, bumpScenario(0.05e-3), "matrix", method);
    for (const double output_step : {5e-3, 7e-3, 50e-3}) {
      const RunResult coarse = run(vehicle, bumpScenario(output_step), "matrix", method);
      for (std::size_t i = 0; i < fine.summaries.size(); ++i) {
        const ColumnSummary& truth = fine.summaries[i];
        const ColumnSummary& ours = coarse.summaries[i];
        const std::string what = fine.history.columns()[i + 1].name + " by " + method;
        EXPECT_NEAR(ours.highest, truth.highest, 1e-3 * truth.peak()) << what;
        EXPECT_NEAR(ours.lowest, truth.lowest, 1e-3 * truth.peak()) << what;
        const double of_means = std::string(method) == "exact" ? 1e-9 * truth.peak() : 1e-3 * truth.rms;
        EXPECT_NEAR(ours.rms, truth.rms, of_means) << what;
        EXPECT_NEAR(ours.mean, truth.mean, of_means) << what;
      }
    }
  }
}

TEST(Measurement, SamplesAloneWouldMissThePeak) {
  const RunResult result = run(contactVehicle(), bumpScenario(5e-3), "matrix", "exact");
  const double seen = peakOf(result.history.column("wheelset_1.az"));
  EXPECT_GT(summaryOf(result, "wheelset_1.az").peak(), 1.2 * seen);
}

// Corrugation of 0.3 m at 58.5 m/s: 195 Hz, in the steady state. The r.m.s. of a whole number of waves is amplitude /
// sqrt 2; its amplitude is what the history of a fine output shows.
TEST(Measurement, OfAWaveFasterThanTheSamplesIsItsOwn) {
  Scenario scenario = paperScenario(History::kExtended);
  scenario.track->harmonics = {harmonic(0.3, 1.0, 0.01e-3)};
  scenario.run.speed = 58.5;
  scenario.run.duration = 0.2;  // 39 waves
  scenario.initial_state.from = InitialRest::kPeriodic;
  Scenario fine = scenario;
  fine.run.output_step = 1e-5;
  const double peak = peakOf(run(contactVehicle(), fine, "matrix", "exact").history.column("front_bogie.az"));
  const ColumnSummary summary = summaryOf(run(contactVehicle(), scenario, "matrix", "exact"), "front_bogie.az");
  EXPECT_NEAR(summary.peak(), peak, 1e-3 * peak);
  EXPECT_NEAR(summary.rms, peak / std::sqrt(2.0), 1e-3 * peak);
}

// The rail's slope jumps under a wheel: the force of its damper and the wheel load of a wheelset with mass jump too, and
// the larger of the two sides counts.
TEST(Measurement, SeesBothSidesOfAJump) {
  Scenario scenario = paperScenario(History::kOnset);
  scenario.track->harmonics = {harmonic(25.0, 1.0, 5e-3)};
  scenario.run.duration = 1.0;
  Scenario fine = scenario;
  fine.run.output_step = 1e-5;
  const TimeHistory history = run(bogiePitchVehicle(), fine, "matrix", "exact").history;
  const RunResult result = run(bogiePitchVehicle(), scenario, "matrix", "exact");
  for (const char* column : {"primary_1.force", "front_bogie.az", "front_bogie.pitch_acc"}) {
    EXPECT_NEAR(summaryOf(result, column).peak(), peakOf(history.column(column)),
                1e-3 * peakOf(history.column(column)));
  }
}

// A pulse of 0.2 ms is one step of 1 ms or less, and Simpson's rule takes a half sine for 4.7 % too much.
TEST(Measurement, FixedStepsFollowAShortPulse) {
  Scenario scenario = paperScenario(History::kOnset);
  scenario.track->harmonics.clear();
  Dip pulse = bump(1e-3, 20.0 * 0.2e-3, 10.0);
  pulse.shape = DipShape::kHalfSine;
  scenario.track->dips = {pulse};
  scenario.run.duration = 1.0;
  const RunResult truth = run(paperVehicle(), scenario, "flat", "exact");
  const RunResult ours = run(paperVehicle(), scenario, "flat", "rk4");
  // The step there is a tenth of the pulse: (pi / 10)^4 / 2880 = 3e-6 for Simpson's rule.
  EXPECT_LT(historyError(ours.history, truth.history), 1e-5);
  RunChoice given;
  given.step = 1e-3;
  EXPECT_GT(historyError(run(paperVehicle(), scenario, "flat", "rk4", given).history, truth.history), 1e-2);
}

TEST(Measurement, EndsWithTheRunWhereThatIsNoMultipleOfTheOutputStep) {
  Scenario scenario = paperScenario(History::kOnset);
  scenario.run.duration = 2.5033;
  scenario.run.output_step = 7e-3;
  for (const char* method : {"exact", "rk4", "dopri5", "rk4_split"}) {
    const RunResult result = run(paperVehicle(), scenario, "flat", method);
    EXPECT_EQ(result.reached, 2.5033) << method;
    EXPECT_EQ(result.history.at(result.history.samples() - 1, 0), 2.5033) << method;
    EXPECT_EQ(result.history.at(result.history.samples() - 2, 0), 2.499) << method;
    EXPECT_EQ(result.outputs, 359) << method;
  }
  EXPECT_EQ(run(paperVehicle(), scenario, "mbs", "simbody_rkm").reached, 2.5033);
}

// int y^2 dt of y = a cos(w t + p) over T: a^2 (T/2 + (sin 2(wT + p) - sin 2p) / 4w). By exact to the rounding of some
// thousand samples.
TEST(Measurement, MeanSquareOfASteadyMotionIsThatOfItsCosine) {
  Scenario scenario = paperScenario(History::kExtended);
  scenario.track->harmonics = {harmonic(25.0, 1.0, 5e-3)};
  scenario.initial_state.from = InitialRest::kPeriodic;
  scenario.run.duration = 3.3;
  const RunResult result = run(paperVehicle(), scenario, "flat", "exact");
  const double w = 2.0 * std::numbers::pi * 20.0 / 25.0, T = 3.3;
  const std::vector<double> z = result.history.column("carbody.z");
  const std::vector<double> v = result.history.column("carbody.vz");
  const double amplitude = std::hypot(z[0], v[0] / w);
  const double phase = std::atan2(-v[0] / w, z[0]);
  const double square = 0.5 * T + (std::sin(2.0 * (w * T + phase)) - std::sin(2.0 * phase)) / (4.0 * w);
  EXPECT_WITHIN(summaryOf(result, "carbody.z").rms, amplitude * std::sqrt(square / T), 1e-12 * amplitude);
  EXPECT_WITHIN(summaryOf(result, "carbody.z").mean, amplitude * (std::sin(w * T + phase) - std::sin(phase)) / (w * T),
                1e-12 * amplitude);
}

TEST(Measurement, SettleLeavesTheStartOut) {
  Scenario scenario = paperScenario(History::kOnset);
  RunChoice choice;
  choice.settle = 9.9975;  // up to the next output sample, which is the end
  EXPECT_EQ(run(paperVehicle(), scenario, "flat", "exact", choice).summaries.front().peak(), 0.0);
  choice.settle = 5.0;
  const RunResult late = run(paperVehicle(), scenario, "flat", "exact", choice);
  double peak = 0.0;
  for (std::size_t i = 1000; i < late.history.samples(); ++i) {
    peak = std::max(peak, std::abs(late.history.at(i, late.history.indexOf("carbody.z"))));
  }
  EXPECT_NEAR(summaryOf(late, "carbody.z").peak(), peak, 1e-3 * peak);
  EXPECT_GE(summaryOf(late, "carbody.z").peakAt(), 5.0 - 5e-3);
}

TEST(Measurement, KeepsNoHistoryWhereNoneIsAskedFor) {
  RunChoice choice;
  choice.keep = Keep::kNothing;
  const RunResult result = run(paperVehicle(), paperScenario(History::kOnset), "flat", "exact", choice);
  EXPECT_EQ(result.history.samples(), 0u);
  EXPECT_EQ(result.outputs, 2001);
  EXPECT_GT(summaryOf(result, "carbody.z").peak(), 4e-3);
}

TEST(Measurement, AHistoryBeyondTheMemoryIsRefusedBeforeTheRun) {
  Scenario scenario = paperScenario(History::kOnset);
  scenario.run.duration = 45000.0;  // 9e6 samples of 32 columns
  const std::string refusal = refusalOf([&] { (void)run(paperVehicle(), scenario, "flat", "exact"); });
  EXPECT_NE(refusal.find("9000001 samples and 33 columns needs 2.2 GiB, allowed are 2"), std::string::npos) << refusal;
}

// ---- steps that are given

std::optional<Warning> warningOf(const RunResult& result, WarningCode code) {
  for (const Warning& each : result.warnings) {
    if (each.code == code) return each;
  }
  return std::nullopt;
}

TEST(GivenStep, BeyondTheLimitOfTheMethodIsSaidToGrow) {
  RunChoice choice;
  choice.step = 0.1;
  Scenario scenario = paperScenario(History::kExtended);
  scenario.run.output_step = 0.1;
  const RunResult result = run(paperVehicle(), scenario, "flat", "rk4", choice);
  const auto warning = warningOf(result, WarningCode::kUnstableStep);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->subject, "--step");
  EXPECT_EQ(warning->value, 0.1);
  EXPECT_TRUE(warningOf(result, WarningCode::kLargeMotion)) << "and so it did";
}

TEST(GivenStep, ThatDoesNotResolveTheFastestMotionIsSaidToBeCoarse) {
  RunChoice choice;
  choice.step = 1e-3;
  EXPECT_TRUE(warningOf(run(contactVehicle(), bumpScenario(5e-3), "matrix", "rk4", choice), WarningCode::kCoarseStep));
  EXPECT_FALSE(
      warningOf(run(paperVehicle(), paperScenario(History::kOnset), "flat", "rk4", choice), WarningCode::kCoarseStep));
}

TEST(ChosenStep, FollowsTheFastestMotionAndSaysSo) {
  const RunResult contact = run(contactVehicle(), bumpScenario(5e-3), "matrix", "rk4");
  EXPECT_TRUE(contact.warnings.empty());
  EXPECT_LT(contact.step, 0.5e-3);
  ASSERT_EQ(contact.notes.size(), 1u);
  EXPECT_NE(contact.notes[0].find("the fastest motion of the vehicle"), std::string::npos);
  const RunResult truth = run(contactVehicle(), bumpScenario(5e-3), "matrix", "exact");
  EXPECT_LT(historyError(contact.history, truth.history), 1e-2);  // 1 ms is off by a third
  const RunResult paper = run(paperVehicle(), paperScenario(History::kOnset), "flat", "rk4");
  EXPECT_EQ(paper.step, 1e-3);
  EXPECT_TRUE(paper.notes.empty());
}

}  // namespace
}  // namespace vehicle::test
