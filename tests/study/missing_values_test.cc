// Values that a design cannot have: they are empty with their reason, and everything else of the design stands.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/study/compare/missing_values.h"
#include "libvehicle/study/evaluate/gap_message.h"
#include "tests/study/inputs.h"

namespace vehicle {
namespace {

using namespace test;

TEST(GapMessage, NamesMetricsOfOneReasonTogetherAndComesApartAgain) {
  const std::vector<Channel> columns = {{"a.rms", ""}, {"b.rms", ""}, {"c.rms", ""}};
  const std::string message =
      gapMessage(columns, {{0, "too narrow; widen it"}, {1, "lost"}, {2, "too narrow; widen it"}});
  EXPECT_EQ(message, "a.rms, c.rms: too narrow; widen it | b.rms: lost");
  EXPECT_EQ(gapsIn(message), (std::vector<std::string_view>{"a.rms, c.rms: too narrow; widen it", "b.rms: lost"}));
  EXPECT_TRUE(gapsIn("").empty());
}

TEST(MissingCount, PutsTheMostFrequentReasonFirst) {
  MissingCount count;
  const std::vector<double> whole = {1.0, 2.0};
  const std::vector<double> gap = {1.0, std::nan("")};
  count.add(whole, "");
  for (const char* message : {"b: rare", "a: often", "a: often | b: third", "a: often"}) count.add(gap, message);
  EXPECT_EQ(count.designs(), 4u);
  const std::vector<MissingValues> list = count.mostFrequent(2);
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].metrics, "a");
  EXPECT_EQ(list[0].reason, "often");
  EXPECT_EQ(list[0].designs, 3u);
  EXPECT_EQ(list[1].designs, 1u);
}

/// A metric that cannot be given beside others that can.
struct Case {
  Vehicle vehicle;
  Evaluation evaluation;
  PathChoice::Kind path;
  std::string metric;
};

// A run of 1 s has a line a hertz; 1 and sqrt(2) have no common period.
TEST(MissingValues, AStatisticThatCannotBeGivenIsEmptyOnEveryPath) {
  const std::string narrow = "carbody.az.band(1.2..1.4 Hz)";
  const std::string percentile = "carbody.az.p95";
  using enum PathChoice::Kind;
  const std::vector<Case> cases = {{paperVehicle(), Evaluation::kRun, kEnsembleRuns, narrow},
                                   {bogiePitchVehicle(), Evaluation::kRun, kSingleRuns, narrow},
                                   {paperVehicle(), Evaluation::kSteadyState, kSteadyEnsemble, percentile},
                                   {bogiePitchVehicle(), Evaluation::kSteadyState, kSteadySingle, percentile}};
  for (const Case& each : cases) {
    Study study =
        studyOf({range("carbody.mass", "30 t", "60 t")}, {"carbody.az.rms", each.metric, "static.wheelset_1.load"});
    study.evaluation = each.evaluation;
    Scenario scenario = paperScenario(History::kExtended);
    scenario.run.duration = 0.995;  // 200 samples of 5 ms
    if (each.evaluation == Evaluation::kSteadyState) {
      scenario.track->harmonics = {harmonic(25.0, 1, 5e-3), harmonic(25.0 / std::numbers::sqrt2, 1, 1e-3)};
    }
    const StudyInputs inputs = inputsOf(study, each.vehicle, {scenario});
    ASSERT_EQ(choosePath(inputs).kind, each.path);
    const Answers answers = answersOf(inputs, {{50e3}, {-1.0}, {40e3}});
    EXPECT_EQ(answers.problems.size(), 1u) << each.metric;  // the design that weighs less than nothing
    ASSERT_EQ(answers.gaps.size(), 2u) << each.metric;
    for (const std::size_t design : {0u, 2u}) {
      EXPECT_GT(answers.metrics[design][0], 0.0);
      EXPECT_TRUE(std::isnan(answers.metrics[design][1]));
      EXPECT_GT(answers.metrics[design][2], 0.0);
      EXPECT_TRUE(answers.gaps.at(static_cast<std::int64_t>(design)).starts_with(each.metric + ": the "))
          << answers.gaps.at(static_cast<std::int64_t>(design));
    }
  }
}

// A spring that carries nothing has no length under load; all else of the design has.
TEST(MissingValues, ASpringWithoutStiffnessHasNoRestDeflectionAndTheOthersStand) {
  Vehicle vehicle = paperVehicle();
  vehicle.elements.push_back(element("parallel", 1e6, 0.0));
  vehicle.suspensions.push_back(suspension("parallel_front", "parallel", "carbody", "front_bogie", 3.725));
  vehicle.suspensions.push_back(suspension("parallel_rear", "parallel", "carbody", "rear_bogie", -3.725));
  Study study = studyOf({range("parallel.stiffness_z", "0 N/m", "2 MN/m")},
                        {"static.parallel_front.deflection", "static.parallel_rear.load", "carbody.az.rms"});
  study.evaluation = Evaluation::kSteadyState;
  const Answers answers = answersOf(inputsOf(study, vehicle, {paperScenario(History::kExtended)}), {{0.0}, {1e6}});
  EXPECT_TRUE(answers.problems.empty());
  ASSERT_EQ(answers.gaps.size(), 1u);
  EXPECT_EQ(answers.gaps.at(0), "static.parallel_front.deflection: it has no stiffness, so no deflection at rest");
  EXPECT_TRUE(std::isnan(answers.metrics[0][0]));
  EXPECT_EQ(answers.metrics[0][1], 0.0);
  EXPECT_GT(answers.metrics[0][2], 0.0);
  EXPECT_GT(answers.metrics[1][0], 0.0);
}

// Without any damping the wave meets the carbody's bounce at one of two speeds: that case alone has no steady state.
TEST(MissingValues, ASteadyStateThatDoesNotExistAtOneSpeedLeavesTheOtherSpeed) {
  Vehicle vehicle = bogiePitchVehicle();
  for (Element& each : vehicle.elements) each.damping_z = 0.0;
  Study study = studyOf({range("carbody.mass", "30 t", "60 t"), list("speed", "20 m/s, 31 m/s")},
                        {"carbody.az.rms", "carbody.z.abs_p90", "static.wheelset_1.load"});
  study.evaluation = Evaluation::kSteadyState;
  Scenario scenario = paperScenario(History::kExtended);
  scenario.track->harmonics = {harmonic(25.0, 1, 5e-3)};
  // The carbody that bounces with its bogies at 20 m/s / 25 m: (k_s - m w^2)(k_s + k_p - m_b w^2) = k_s^2.
  const double w = 2.0 * std::numbers::pi * 20.0 / 25.0;
  const double secondary = 2.0 * vehicle.elements[1].stiffness_z;
  const double primary = 4.0 * vehicle.elements[0].stiffness_z;
  const double bogies = 2.0 * vehicle.bodies[1].mass;
  const double mass = (secondary - secondary * secondary / (secondary + primary - bogies * w * w)) / (w * w);
  const Answers answers = answersOf(inputsOf(study, vehicle, {scenario}), {{mass}, {0.9 * mass}});
  EXPECT_TRUE(answers.problems.empty());
  ASSERT_EQ(answers.gaps.size(), 1u);
  EXPECT_TRUE(answers.gaps.at(0).starts_with("carbody.az.rms @ 72 km/h, carbody.z.abs_p90 @ 72 km/h: "))
      << answers.gaps.at(0);
  for (const std::size_t at_the_first_speed : {0u, 2u}) EXPECT_TRUE(std::isnan(answers.metrics[0][at_the_first_speed]));
  for (const std::size_t others : {1u, 3u, 4u}) EXPECT_GT(answers.metrics[0][others], 0.0);
}

}  // namespace
}  // namespace vehicle
