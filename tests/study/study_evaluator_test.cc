#include "libvehicle/study/evaluate/study_evaluator.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "libvehicle/ensemble/ensemble.h"
#include "libvehicle/simulate/simulate.h"
#include "libvehicle/study/evaluate/column_statistic.h"
#include "libvehicle/study/evaluate/summary_statistic.h"
#include "tests/study/inputs.h"
#include "tests/support/tolerance.h"
#include "tests/support/trains.h"

namespace vehicle {
namespace {

using namespace test;

const std::vector<std::string> kEverything = {
    "carbody.az.rms",          "carbody.az.mean",       "carbody.az.peak",          "carbody.az.min",
    "carbody.z.max",           "carbody.az.p95",        "carbody.az.abs_p90",       "carbody.az.band(0.5..3 Hz)",
    "secondary_front.deflection.peak", "wheelset_3.load.min", "rear_bogie.vz.rms", "primary_2.force.rms"};

/// Metrics of columns from histories of simulate(), design by design, in the order of a row.
std::vector<std::vector<double>> fromHistories(const StudyInputs& inputs,
                                               const std::vector<std::vector<double>>& designs,
                                               const RunChoice& given) {
  std::vector<std::vector<double>> rows;
  ColumnStatistic statistic;
  for (const std::vector<double>& values : designs) {
    Vehicle vehicle = inputs.vehicle;
    std::vector<Scenario> scenarios = inputs.scenarios;
    apply(inputs.bound, values, vehicle, scenarios);
    std::vector<double>& row = rows.emplace_back();
    for (const MetricColumn& each : metricColumns(inputs.bound)) {
      const StudyCase& study_case = inputs.bound.cases[*each.study_case];
      const Scenario& scenario = scenarios[study_case.scenario];
      RunChoice choice = given;
      choice.speed = speedOf(inputs.bound, study_case, scenario);
      choice.settle = inputs.study.settle;
      choice.keep = Keep::kRegular;
      const RunResult result = simulate(vehicle, scenario, choice);
      const Metric& metric = inputs.bound.metrics[each.metric].metric;
      const std::size_t place = result.history.indexOf(metric.subject);
      if (comesFromSummary(metric.statistic)) {
        row.push_back(fromSummary(metric.statistic, result.summaries[place - 1]));
        continue;
      }
      const std::vector<double> column = result.history.column(place);
      const double step = result.history.at(1, 0) - result.history.at(0, 0);
      const auto first = static_cast<std::size_t>(firstCounted(inputs.study.settle, step));
      row.push_back(statistic(metric, std::span(column).subspan(first), step));
    }
  }
  return rows;
}

void expectNear(const Answers& answers, const std::vector<std::vector<double>>& expected, double relative) {
  EXPECT_TRUE(answers.problems.empty()) << answers.problems.begin()->second;
  ASSERT_EQ(answers.metrics.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(answers.metrics[i].size(), expected[i].size());
    for (std::size_t m = 0; m < expected[i].size(); ++m) {
      EXPECT_WITHIN(answers.metrics[i][m], expected[i][m], relative * std::abs(expected[i][m]))
          << "design " << i << " metric " << m;
    }
  }
}

/// Without the mean of an acceleration, which is the rounding of a sum about zero.
std::vector<std::string> everythingButMean() {
  std::vector<std::string> metrics = kEverything;
  std::erase(metrics, "carbody.az.mean");
  return metrics;
}

RunChoice scalarRun() {
  RunChoice choice;
  choice.form = "flat";
  choice.method = "rk4";
  return choice;
}

// The ensemble and the scalar run take the same steps; fused multiply-adds and the order of sums differ (1e-15 a step,
// damped): 1e-12 of each metric is two decades above what was seen.
TEST(StudyEvaluator, RunsOfAnEnsembleGiveTheMetricsOfHistories) {
  Study study = studyOf({range("secondary.stiffness_z", "1 MN/m", "4 MN/m"), range("carbody.mass", "40 t", "60 t"),
                         list("speed", "20 m/s, 31 m/s")},
                        everythingButMean());
  study.settle = 1.0;
  Scenario scenario = paperScenario(History::kOnset);
  scenario.run.duration = 4.0;
  const StudyInputs inputs = inputsOf(study, paperVehicle(), {scenario});
  const std::vector<std::vector<double>> designs = {{2660e3, 57e3}, {2.1e6, 55e3}, {3.9e6, 59e3}};
  ASSERT_EQ(choosePath(inputs).kind, PathChoice::Kind::kEnsembleRuns);
  expectNear(answersOf(inputs, designs), fromHistories(inputs, designs, scalarRun()), 1e-12);
  // The bound of a design that is damped strongly makes the ensemble look twice as often as the eigenvalues ask for:
  // percentiles and bands are those of samples, here 5 ms or 2.5 ms apart.
  const std::vector<std::vector<double>> damped = {{1.1e6, 41e3}};
  expectNear(answersOf(inputs, damped), fromHistories(inputs, damped, scalarRun()), 5e-3);
}

// The same where every design brings rails of its own: a wheel that stands elsewhere meets the rail at another time.
TEST(StudyEvaluator, AParameterOfGeometryReachesTheWheelDelays) {
  Study study =
      studyOf({range("wheelset_1.x, primary_1.x", "7 m", "9 m"), range("speed", "15 m/s", "30 m/s"),
               range("scenario.long.amplitude", "1 mm", "6 mm"), range("scenario.gravity", "9 m/s^2", "10 m/s^2")},
              everythingButMean());
  Scenario scenario = paperScenario(History::kOnset);
  scenario.run.duration = 2.0;
  scenario.track->harmonics[0].name = "long";
  const StudyInputs inputs = inputsOf(study, asymmetricVehicle(), {scenario});
  ASSERT_EQ(inputs.bound.parameters.size(), 5u);
  ASSERT_EQ(inputs.bound.parameters[2].address, "speed");
  const std::vector<std::vector<double>> designs = {{7.6, 7.6, 20.0, 5e-3, 9.81}, {8.4, 8.4, 27.0, 2e-3, 9.2}};
  const Answers answers = answersOf(inputs, designs);
  expectNear(answers, fromHistories(inputs, designs, scalarRun()), 1e-12);
  // And it is felt: a rail met 0.8 m earlier is another motion.
  const Answers moved = answersOf(inputs, {{8.4, 8.4, 20.0, 5e-3, 9.81}});
  EXPECT_GT(std::abs(moved.metrics[0][0] / answers.metrics[0][0] - 1.0), 1e-3);
}

TEST(StudyEvaluator, StartsAsTheScenarioSays) {
  Study study = studyOf({range("carbody.mass", "40 t", "60 t")}, everythingButMean());
  Scenario scenario = paperScenario(History::kExtended);
  scenario.run.duration = 1.0;
  scenario.initial_state.from = InitialRest::kPeriodic;
  scenario.initial_state.bodies.push_back({"carbody", 2e-3, 0.0, 0.0, 1e-3, {}});
  const StudyInputs inputs = inputsOf(study, paperVehicle(), {scenario});
  const std::vector<std::vector<double>> designs = {{57e3}, {41e3}};
  expectNear(answersOf(inputs, designs), fromHistories(inputs, designs, scalarRun()), 1e-12);
}

// 30 s leave 1e-11 of the slowest motion (e^(-0.75 30) at the worst of these designs and less at the others); the 5 s
// that count are whole periods at both speeds. 1e-9 asked.
TEST(StudyEvaluator, TheSteadyStateIsWhereALongRunEnds) {
  const std::vector<std::string> metrics = {
      "carbody.az.rms",       "carbody.pitch.rms",         "rear_bogie.az.rms",
      "wheelset_2.load.mean", "secondary_front.force.rms", "carbody.az.band(0.5..1.5 Hz)"};
  for (const Vehicle& vehicle : {paperVehicle(), asymmetricVehicle()}) {
    const std::string spring = vehicle.name == "asymmetric" ? "secondary_soft" : "secondary";
    Study study =
        studyOf({range(spring + ".stiffness_z", "1 MN/m", "4 MN/m"), list("speed", "20 m/s, 25 m/s")}, metrics);
    study.evaluation = Evaluation::kSteadyState;
    const std::vector<std::vector<double>> designs = {{2e6}, {3.3e6}};
    const StudyInputs inputs = inputsOf(study, vehicle, {paperScenario(History::kOnset)});
    ASSERT_EQ(choosePath(inputs).kind, PathChoice::Kind::kSteadyEnsemble);

    study.evaluation = Evaluation::kRun;
    study.settle = 40.0;
    Scenario scenario = paperScenario(History::kExtended);
    scenario.run.duration = 45.0;
    const StudyInputs long_run = inputsOf(study, vehicle, {scenario});
    expectNear(answersOf(inputs, designs), fromHistories(long_run, designs, {}), 1e-9);
  }
}

// The matrix form's closed form shares no line with the ensemble's. Peaks: the ensemble's 64 samples a period of the
// highest order and a parabola, 6e-6 seen where waves of two orders meet; percentiles are as fine as 4096 samples,
// here the same ones.
TEST(StudyEvaluator, BothClosedFormsAgree) {
  for (const Vehicle& vehicle : {paperVehicle(), asymmetricVehicle(), heightsVehicle()}) {
    Study study = studyOf({range("carbody.mass", "40 t", "60 t"), list("speed", "20 m/s, 31 m/s")}, kEverything);
    study.evaluation = Evaluation::kSteadyState;
    Scenario scenario = paperScenario(History::kExtended);
    scenario.track->harmonics[1].phase = 0.4;
    const StudyInputs inputs = inputsOf(study, vehicle, {scenario});
    const std::vector<std::vector<double>> designs = {{57e3}, {41e3}, {-3.0}};
    const Answers flat = answersBy(inputs, PathChoice::Kind::kSteadyEnsemble, designs);
    const Answers matrix = answersBy(inputs, PathChoice::Kind::kSteadySingle, designs);
    ASSERT_EQ(flat.problems.size(), 1u);
    ASSERT_EQ(matrix.problems.size(), 1u);
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t m = 0; m < flat.metrics[i].size(); ++m) {
        const Statistic statistic = inputs.bound.metrics[metricColumns(inputs.bound)[m].metric].metric.statistic;
        const bool peak = statistic == Statistic::kPeak || statistic == Statistic::kMin || statistic == Statistic::kMax;
        EXPECT_WITHIN(flat.metrics[i][m], matrix.metrics[i][m],
                      (peak ? 2e-5 : 1e-11) * std::abs(matrix.metrics[i][m]) + 1e-15)
            << vehicle.name << " metric " << m;
      }
    }
  }
}

// A bogie that pitches is none of the flat form's: the study says so and gives exactly what simulate() gives.
TEST(StudyEvaluator, FallsBackToSingleRunsAndSaysWhy) {
  Study study = studyOf({range("secondary.stiffness_z", "400 kN/m", "1.2 MN/m")}, everythingButMean());
  study.settle = 0.5;
  Scenario scenario = paperScenario(History::kOnset);
  scenario.run.duration = 2.0;
  const StudyInputs inputs = inputsOf(study, bogiePitchVehicle(), {scenario});
  const PathChoice path = choosePath(inputs);
  EXPECT_EQ(path.kind, PathChoice::Kind::kSingleRuns);
  EXPECT_NE(path.text.find("exact, matrix form, design by design"), std::string::npos) << path.text;
  EXPECT_NE(path.text.find("has a pitch motion; the form flat computes the bounce of a bogie and no pitch"),
            std::string::npos)
      << path.text;
  const std::vector<std::vector<double>> designs = {{860e3}, {500e3}, {1.1e6}};
  const auto expected = fromHistories(inputs, designs, {});
  for (const int threads : {1, 3}) EXPECT_EQ(answersOf(inputs, designs, threads).metrics, expected);
}

// 72 states are more than exact takes unless it is asked for: the study names the method that its runs take.
TEST(StudyEvaluator, NamesTheMethodThatALongTrainIsRunBy) {
  const Vehicle nine = assembled(equalTrain(paperVehicle(), 9, 16.0));
  const Study study = studyOf({range("speed", "15 m/s", "30 m/s")}, {"coach_1.carbody.az.rms"});
  const StudyInputs inputs = inputsOf(study, nine, {paperScenario(History::kOnset)});
  EXPECT_TRUE(choosePath(inputs).text.starts_with("runs by dopri5, flat form")) << choosePath(inputs).text;
}

TEST(StudyEvaluator, ADesignThatCannotBeIsReportedAlone) {
  for (const Evaluation evaluation : {Evaluation::kRun, Evaluation::kSteadyState}) {
    Study study = studyOf({range("carbody.mass", "40 t", "60 t"), range("secondary.stiffness_z", "1 MN/m", "4 MN/m")},
                          {"carbody.az.rms", "carbody.z.peak"});
    study.evaluation = evaluation;
    Scenario scenario = paperScenario(History::kExtended);
    scenario.run.duration = 1.0;
    const StudyInputs inputs = inputsOf(study, paperVehicle(), {scenario});
    const std::vector<double> good = {57e3, 2660e3};
    const Answers alone = answersOf(inputs, {good});
    const Answers answers =
        answersOf(inputs, {good, {-1.0, 2660e3}, good, {57e3, std::nan("")}, {0.0, 2660e3}, good, {57e3, -5.0}, good});
    ASSERT_EQ(answers.problems.size(), 4u);
    EXPECT_EQ(answers.problems.at(1), "<vehicle><body name=\"carbody\">: mass=\"-1 kg\"; must be > 0");
    EXPECT_TRUE(answers.problems.contains(3));
    EXPECT_TRUE(answers.problems.contains(4));
    EXPECT_TRUE(answers.problems.contains(6));
    for (const std::size_t i : {0u, 2u, 5u, 7u}) EXPECT_EQ(answers.metrics[i], alone.metrics[0]);
    EXPECT_TRUE(std::isnan(answers.metrics[1][0]));
  }
}

TEST(StudyEvaluator, AMotionThatIsLostFailsItsDesignAlone) {
  // A centre of mass 200 km up falls over with e^(300 t): no number holds it for 5 s.
  Study study = studyOf({range("carbody.z", "1 m", "2 m")}, {"carbody.az.rms", "carbody.az.p95"});
  const StudyInputs inputs = inputsOf(study, heightsVehicle(), {paperScenario(History::kOnset)});
  const Answers alone = answersOf(inputs, {{1.6}});
  const Answers answers = answersOf(inputs, {{1.6}, {2e5}, {1.6}});
  ASSERT_EQ(answers.problems.size(), 1u);
  EXPECT_NE(answers.problems.at(1).find("no longer finite at t = "), std::string::npos) << answers.problems.at(1);
  EXPECT_EQ(answers.metrics[0], alone.metrics[0]);
  EXPECT_EQ(answers.metrics[2], alone.metrics[0]);
}

// A spring of 10^14 N/m is followed, with the steps that it needs; one of 10^18 N/m says that it cannot be.
TEST(StudyEvaluator, StepsFollowTheFastestMotionOfADesign) {
  Study study = studyOf({range("primary.stiffness_z", "1 MN/m", "4 MN/m")}, {"carbody.az.rms", "carbody.az.p95"});
  Scenario scenario = paperScenario(History::kOnset);
  scenario.run.duration = 0.5;
  const StudyInputs inputs = inputsOf(study, paperVehicle(), {scenario});
  const std::vector<std::vector<double>> designs = {{3040e3}, {1e11}, {1e18}};
  const Answers answers = answersOf(inputs, designs);
  ASSERT_EQ(answers.problems.size(), 1u);
  EXPECT_NE(answers.problems.at(2).find("its fastest motion asks for rk4 steps of"), std::string::npos)
      << answers.problems.at(2);
  RunChoice choice;
  choice.form = "matrix";
  choice.method = "exact";
  const auto exact = fromHistories(inputs, {designs[0], designs[1]}, choice);
  // Steps and samples of rk4 are chosen for 1e-4 of the fastest motion, which hardly moves the carbody.
  for (std::size_t i = 0; i < 2; ++i) EXPECT_WITHIN(answers.metrics[i][0], exact[i][0], 1e-5 * exact[i][0]);
}

// Static loads by hand; eigenvalues of the paper's vehicle as in tests of `linear` (docs/theory): bounce
// -0.883650 +- 7.932963 j. Their six digits are what is compared.
TEST(StudyEvaluator, RestAndModesAreMetricsToo) {
  const std::vector<std::string> metrics = {"static.secondary_front.load", "static.secondary_rear.deflection",
                                            "static.wheelset_1.load", "mode.carbody bounce.frequency",
                                            "mode.carbody bounce.damping"};
  Study study = studyOf({range("carbody.mass", "40 t", "60 t"), list("speed", "20 m/s, 31 m/s")}, metrics);
  study.metrics.push_back({"carbody.az.rms", {}});
  Scenario scenario = paperScenario(History::kOnset);
  scenario.run.duration = 1.0;
  const StudyInputs inputs = inputsOf(study, paperVehicle(), {scenario});
  const Answers answers = answersOf(inputs, {{57e3}, {40e3}});
  ASSERT_TRUE(answers.problems.empty()) << answers.problems.begin()->second;
  ASSERT_EQ(answers.metrics[0].size(), 7u);  // the five of the vehicle once, the r.m.s. at both speeds
  const double omega = std::hypot(0.883650, 7.932963);
  EXPECT_WITHIN(answers.metrics[0][0], 57e3 * 9.81 / 2.0, 1e-6);
  EXPECT_WITHIN(answers.metrics[0][1], 57e3 * 9.81 / 2.0 / 2660e3, 1e-12);
  EXPECT_WITHIN(answers.metrics[0][2], (57e3 / 4.0 + 9e3 / 2.0) * 9.81, 1e-6);
  EXPECT_WITHIN(answers.metrics[0][3], omega / (2.0 * std::numbers::pi), 1e-6);
  EXPECT_WITHIN(answers.metrics[0][4], 0.883650 / omega, 1e-6);
  EXPECT_GT(answers.metrics[1][3], answers.metrics[0][3]);  // a lighter carbody bounces faster
}

// Two wheels that change places change what "wheelset_1" means to columns that were looked up before.
TEST(StudyEvaluator, ADesignThatReordersTheVehicleFailsWithTheReason) {
  const Vehicle vehicle = paperVehicle();
  const double ahead = vehicle.wheelsets[0].x;
  const double behind = vehicle.wheelsets[1].x;
  ASSERT_GT(ahead, behind);
  for (const Evaluation evaluation : {Evaluation::kSteadyState, Evaluation::kRun}) {
    Study study = studyOf(
        {range("wheelset_1.x, primary_1.x", "1 m", "9 m"), range("wheelset_2.x, primary_2.x", "1 m", "9 m")},
        {"wheelset_1.load.mean"});
    study.evaluation = evaluation;
    Scenario scenario = paperScenario(History::kExtended);
    scenario.run.duration = 1.0;
    const Answers answers = answersOf(inputsOf(study, vehicle, {scenario}),
                                      {{ahead, ahead, behind, behind}, {behind, behind, ahead, ahead}});
    ASSERT_EQ(answers.problems.size(), 1u);
    EXPECT_EQ(answers.problems.at(1), "its bogies or wheelsets stand in another order than the base's; give that order "
                                      "a vehicle file and a study of its own");
  }
}

// A wave of 1 m at 39.6 km/h is 11 Hz, and 10.999999999999998 Hz by the floating-point way there.
TEST(StudyEvaluator, AHarmonicOnABandsLimitIsInIt) {
  Scenario scenario = paperScenario(History::kExtended);
  scenario.track->harmonics = {harmonic(1.0, 1, 1e-3)};
  const std::vector<std::string> metrics = {"carbody.az.rms", "carbody.az.band(11..12 Hz)",
                                            "carbody.az.band(10..11 Hz)"};
  Study study = studyOf({range("carbody.mass", "40 t", "60 t"), list("speed", "39.6 km/h")}, metrics);
  study.evaluation = Evaluation::kSteadyState;
  const Answers answers = answersOf(inputsOf(study, paperVehicle(), {scenario}), {{57e3}});
  ASSERT_TRUE(answers.problems.empty()) << answers.problems.begin()->second;
  EXPECT_GT(answers.metrics[0][0], 0.0);
  EXPECT_WITHIN(answers.metrics[0][1] / answers.metrics[0][0], 1.0, 1e-14);
  EXPECT_EQ(answers.metrics[0][2], 0.0);
}

TEST(StudyEvaluator, WhatIsWrongWithTheStudyIsToldBeforeAnyDesign) {
  Study study = studyOf({range("carbody.mass", "40 t", "60 t")}, {"carbody.az.rms"});
  StudyInputs late = inputsOf(study, paperVehicle(), {paperScenario(History::kOnset)});
  late.study.settle = 100.0;  // past bindStudy(), which refuses it
  EXPECT_THROW(StudyEvaluator{late}, std::invalid_argument);

  study.evaluation = Evaluation::kSteadyState;
  Scenario dip = paperScenario(History::kOnset);
  dip.track->dips.push_back({"", DipShape::kOneMinusCosine, 0.01, 5.0, 20.0, {}, {}});
  const StudyInputs once = inputsOf(study, paperVehicle(), {dip});
  EXPECT_THROW(StudyEvaluator{once}, InvalidInput);
}

}  // namespace
}  // namespace vehicle
