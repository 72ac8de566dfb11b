#include "libvehicle/model/bound_study.h"

#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/studies.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle {
namespace {

Origin line(int number) {
  Origin origin;
  origin.file = "s.xml";
  origin.line = number;
  return origin;
}

Study springs() {
  Study made;
  made.name = "springs";
  made.vehicle.file = "coach.xml";
  made.scenarios = {{"track.xml", {}}};
  Vary stiffness = test::range("secondary.stiffness_z", "500 kN/m", "900 kN/m", 5);
  stiffness.origin = line(4);
  made.varies = {stiffness};
  made.designs = {{"light", "", {{"front_bogie.mass, rear_bogie.mass", "7 t", line(8)}}, line(7)}};
  made.metrics = {
      {"carbody.az.rms", {}}, {"secondary_front.deflection.peak", {}}, {"mode.carbody bounce.frequency", {}}};
  made.objectives = {{"carbody.az.rms", Goal::kMaximise, Over::kMean, {}}};
  made.limits = {{"secondary_front.deflection.peak", "30 mm", "", line(12)}};
  return made;
}

Outcome<BoundStudy> boundAfter(const std::function<void(Study&)>& change) {
  Study made = springs();
  change(made);
  EXPECT_EQ(check(made).text(), "");
  return bindStudy(made, test::paperVehicle(), {test::waves("calm", 1e-3)});
}

std::string problemsAfter(const std::function<void(Study&)>& change) { return boundAfter(change).problems.text(); }

TEST(BindStudy, NamesBecomePlacesAndValuesBecomeSi) {
  const BoundStudy bound = boundAfter([](Study&) {}).orThrow();
  ASSERT_EQ(bound.parameters.size(), 3u);
  EXPECT_EQ(bound.parameters[0].base, 2660e3);
  ASSERT_EQ(bound.factors.size(), 1u);
  EXPECT_EQ(bound.factors[0].levels, (std::vector<double>{500e3, 600e3, 700e3, 800e3, 900e3}));
  ASSERT_EQ(bound.designs.size(), 2u);
  EXPECT_EQ(bound.designs[0].name, "base");
  EXPECT_EQ(bound.designs[1].sets, (std::vector<std::pair<std::size_t, double>>{{1, 7e3}, {2, 7e3}}));
  ASSERT_EQ(bound.cases.size(), 1u);
  EXPECT_EQ(bound.cases[0].speed, 20.0);
  EXPECT_EQ(bound.objectives[0].goal, Goal::kMaximise);
  EXPECT_EQ(bound.limits[0].metric, 1u);
  EXPECT_EQ(bound.limits[0].below, 0.03);
  EXPECT_EQ(parameterColumns(bound)[1], (Channel{"front_bogie.mass", "kg"}));
}

TEST(BindStudy, SpeedsAndScenariosAreCasesAndEveryColumnSaysWhich) {
  Study study = springs();
  study.scenarios.push_back({"rough.xml", {}});
  Vary speed;
  speed.parameter = "speed";
  speed.values = "80 km/h, 120 km/h";
  study.varies.push_back(speed);
  const std::vector<Scenario> scenarios = {test::waves("calm", 1e-3), test::waves("rough", 9e-3)};
  const BoundStudy bound = bindStudy(study, test::paperVehicle(), scenarios).orThrow();
  ASSERT_EQ(bound.cases.size(), 4u);
  EXPECT_EQ(bound.cases[3].scenario, 1u);
  EXPECT_EQ(bound.cases[3].speed, 120.0 / 3.6);
  const std::vector<MetricColumn> columns = metricColumns(bound);
  ASSERT_EQ(columns.size(), 4u + 4u + 1u);
  EXPECT_EQ(columns[2].channel, (Channel{"carbody.az.rms @ rough, 80 km/h", "m/s^2"}));
  EXPECT_EQ(columns[8].channel, (Channel{"mode.carbody bounce.frequency", "Hz"}));
  EXPECT_FALSE(columns[8].study_case.has_value());
}

TEST(BindStudy, AppliedValuesStandInVehicleAndScenarios) {
  Study study = springs();
  study.varies[0].parameter = "scenario.wave.amplitude";
  study.varies[0].from = "1 mm";
  study.varies[0].to = "5 mm";
  const BoundStudy bound = bindStudy(study, test::paperVehicle(), {test::waves("calm", 1e-3)}).orThrow();
  Vehicle vehicle = test::paperVehicle();
  std::vector<Scenario> scenarios = {test::waves("calm", 1e-3)};
  apply(bound, std::vector<double>{4e-3, 7e3, 6e3}, vehicle, scenarios);
  EXPECT_EQ(scenarios[0].track->harmonics[0].amplitude, 4e-3);
  EXPECT_EQ(vehicle.bodies[1].mass, 7e3);
  EXPECT_EQ(vehicle.bodies[2].mass, 6e3);
}

struct Wrong {
  std::function<void(Study&)> change;
  const char* says;
};

TEST(BindStudy, WhatDoesNotFitTheVehicleIsTold) {
  const std::vector<Wrong> cases = {
      {[](Study& made) { made.varies[0].parameter = "secundary.stiffness_z"; },
       "s.xml:4: error: <study><vary>: parameter \"secundary.stiffness_z\" is unknown; did you mean "
       "\"secondary.stiffness_z\"?\n"},
      {[](Study& made) { made.varies[0].parameter = "secondary.colour_of_paint"; },
       "s.xml:4: error: <study><vary>: parameter \"secondary.colour_of_paint\" is unknown; write PART.ATTRIBUTE; it "
       "has "
       "secondary.stiffness_z, secondary.damping_z\n"},
      {[](Study& made) { made.varies[0].from = "20 kN*s/m"; },
       "s.xml:4: error: <study><vary>: from=\"20 kN*s/m\" is a damping; a stiffness is expected, e.g. \"3040 kN/m\"\n"},
      {[](Study& made) { made.varies[0].from = "1 MN/m"; },
       "s.xml:4: error: <study><vary>: from=\"1 MN/m\" is not below to=\"900 kN/m\"; a range goes from the lower to "
       "the "
       "higher\n"},
      {[](Study& made) { made.varies[0].from = "-100 kN/m"; },
       "s.xml:4: error: <study><vary>: secondary.stiffness_z = -100 kN/m is not possible: stiffness_z=\"-100 kN/m\"; "
       "must "
       "be >= 0\n"},
      {[](Study& made) { made.varies[0].kind = Variation::kRelative; },
       "s.xml:4: error: <study><vary>: from=\"500 kN/m\" is a stiffness; a plain number is expected, e.g. \"3\"\n"
       "s.xml:4: error: <study><vary>: to=\"900 kN/m\" is a stiffness; a plain number is expected, e.g. \"3\"\n"},
      {[](Study& made) {
         made.varies[0] = test::range("carbody.x", "50 %", "150 %", 5);
         made.varies[0].kind = Variation::kRelative;
         made.varies[0].origin = line(4);
       },
       "s.xml:4: error: <study><vary>: carbody.x is 0 in the file, and so is every part of it; vary it with "
       "kind=\"absolute\"\n"},
      {[](Study& made) { made.varies[0].parameter = "secondary.stiffness_z, carbody.mass"; },
       "s.xml:4: error: <study><vary>: secondary.stiffness_z and carbody.mass are of different kinds; tie them with "
       "kind=\"relative\"\n"},
      {[](Study& made) { made.varies[0].parameter = "wheelset_1.load"; },
       "s.xml:4: error: <study><vary>: the files give no value for wheelset_1.load; write one there: the design "
       "\"base\" "
       "needs it\n"},
      {[](Study& made) { made.designs[0].sets[0].value = "7"; },
       "s.xml:8: error: <study><design><set>: value=\"7\" has no unit; a mass is expected, e.g. \"57 t\"\n"},
      {[](Study& made) { made.designs[0].sets[0].value = "0 t"; },
       "s.xml:7: error: <study><design>: front_bogie.mass = 0 kg, rear_bogie.mass = 0 kg is not possible: mass=\"0 "
       "kg\"; "
       "must be > 0\n"},
      {[](Study& made) {
         made.metrics.push_back({"carbody.zz.rms", line(11)});
       },
       "s.xml:11: error: <study><metric>: name=\"carbody.zz.rms\" asks for a column that the vehicle "
       "\"al-oraiqat-2017\" "
       "has not; did you mean \"carbody.z\"?\n"},
      {[](Study& made) {
         made.metrics.push_back({"static.wheelset_1.deflection", line(11)});
       },
       "s.xml:11: error: <study><metric>: name=\"static.wheelset_1.deflection\" asks for the deflection of a wheelset; "
       "name a suspension\n"},
      {[](Study& made) {
         made.metrics.push_back({"static.primary_9.load", line(11)});
       },
       "s.xml:11: error: <study><metric>: name=\"static.primary_9.load\" names no suspension or wheelset; did you mean "
       "\"primary_1\"?\n"},
      {[](Study& made) { made.limits[0].below = "30 kN"; },
       "s.xml:12: error: <study><limit>: below=\"30 kN\" is a force; a length is expected, e.g. \"3.725 m\"\n"},
      {[](Study& made) { made.limits[0].above = "40 mm"; },
       "s.xml:12: error: <study><limit>: above=\"40 mm\" is not under below=\"30 mm\"; what may be lies between them: "
       "above=\"LOWER\" below=\"HIGHER\"\n"},
  };
  for (const Wrong& each : cases) EXPECT_EQ(problemsAfter(each.change), each.says);
}

TEST(BindStudy, ASpeedIsListedOrVariedAndNotBoth) {
  Study made = springs();
  made.varies = {test::list("speed", "30 km/h, 90 km/h")};
  made.designs.clear();
  made.plan.emplace();
  made.plan->kind = PlanKind::kList;
  made.plan->file = "designs.csv";
  made.plan->origin = line(5);
  const Vehicle vehicle = test::paperVehicle();
  const std::vector<Scenario> scenarios = {test::waves("calm", 1e-3)};
  EXPECT_EQ(bindStudy(made, vehicle, scenarios, {{{"speed", "m/s"}}, {}}).problems.text(),
            "s.xml:5: error: <study><plan>: lists \"speed\", and a <vary> gives speeds that every design runs at; "
            "remove one of them\n");
  EXPECT_TRUE(bindStudy(made, vehicle, scenarios, {{{"carbody.mass", "t"}}, {}}).problems.empty());
}

TEST(BindStudy, ScenariosThatDisagreeOnAVariedNumberAreTold) {
  Study study = springs();
  study.scenarios.push_back({"rough.xml", {}});
  study.varies[0].parameter = "scenario.wave.amplitude";
  study.varies[0].from = "1 mm";
  study.varies[0].to = "5 mm";
  const std::vector<Scenario> differing = {test::waves("calm", 1e-3), test::waves("rough", 9e-3)};
  EXPECT_EQ(
      bindStudy(study, test::paperVehicle(), differing).problems.text(),
      "s.xml:4: error: <study><vary>: the scenarios give different values for scenario.wave.amplitude; give it the "
      "same value in all of them, or make a study of each\n");
  const std::vector<Scenario> namesakes = {test::waves("calm", 1e-3), test::waves("calm", 1e-3)};
  EXPECT_EQ(bindStudy(study, test::paperVehicle(), namesakes).problems.text(),
            "error: <study name=\"springs\">: two scenarios are both named \"calm\"; give each a name of its own\n");
}

TEST(BindStudy, AStandingVehicleIsNoSpeedOfAStudy) {
  EXPECT_EQ(problemsAfter([](Study& made) {
              Vary speed;
              speed.parameter = "speed";
              speed.values = "0 km/h, 80 km/h";
              speed.origin = line(5);
              made.varies.push_back(speed);
            }),
            "s.xml:5: error: <study><vary>: has a speed that is not above 0; a vehicle runs at all of them\n");
}

TEST(BindStudy, ASettleLongerThanARunIsToldBeforeTheFirstRun) {
  Scenario way = test::waves("calm", 1e-3);
  way.run.duration.reset();
  way.run.distance = 100.0;  // 5 s at 20 m/s
  const auto problems = [&](const std::string& settle, Evaluation evaluation) {
    Study made = springs();
    made.origin = line(2);
    made.evaluation = evaluation;
    made.settle = parseQuantity(settle, Dimension::kTime).si.value();
    return bindStudy(made, test::paperVehicle(), {way}).problems.text();
  };
  EXPECT_EQ(problems("5 s", Evaluation::kRun), "");
  EXPECT_EQ(problems("6 s", Evaluation::kRun),
            "s.xml:2: error: <study>: settle=\"6 s\" leaves nothing of the run over \"calm\", which "
            "lasts 5 s; settle less, or run longer\n");
  EXPECT_EQ(problems("6 s", Evaluation::kSteadyState), "");
}

TEST(BindStudy, WhatASteadyStateDoesNotHaveIsNoParameterOfIt) {
  for (const char* address : {"scenario.duration", "scenario.output_step", "scenario.distance", "scenario.fade_in"}) {
    Study made = springs();
    made.evaluation = Evaluation::kSteadyState;
    made.designs.push_back({"other", "", {{address, "1 s", line(7)}}, line(6)});
    EXPECT_EQ(
        bindStudy(made, test::paperVehicle(), {test::waves("calm", 1e-3)}).problems.text(),
        std::string("s.xml:7: error: <study><design><set>: ") + address +
            " has no effect with evaluation=\"steady_state\", which has neither start nor end; remove it, or take "
            "evaluation=\"run\"\n");
  }
}

TEST(ValueAt, RangesEndExactlyAndLogarithmicOnesDivideByRatio) {
  Factor factor;
  factor.from = 0.1;
  factor.to = 1000.0;
  EXPECT_EQ(valueAt(factor, 0.0), 0.1);
  EXPECT_EQ(valueAt(factor, 1.0), 1000.0);
  EXPECT_WITHIN(valueAt(factor, 0.5), 500.05, 1e-12);  // two roundings
  factor.spacing = Spacing::kLogarithmic;
  EXPECT_WITHIN(valueAt(factor, 0.25), 1.0, 1e-15);  // pow's
  EXPECT_EQ(valueAt(factor, 1.0), 1000.0);
  factor.levels = {3.0, 1.0, 2.0};
  EXPECT_EQ(valueAt(factor, 0.0), 3.0);
  EXPECT_EQ(valueAt(factor, 0.34), 1.0);
  EXPECT_EQ(valueAt(factor, 1.0), 2.0);
}

}  // namespace
}  // namespace vehicle
