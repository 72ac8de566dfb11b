#include "libvehicle/definition/study.h"

#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/studies.h"

namespace vehicle {
namespace {

Origin line(int number) {
  Origin origin;
  origin.file = "study.xml";
  origin.line = number;
  return origin;
}

Study springs() {
  Study made;
  made.name = "springs";
  made.origin = line(1);
  made.vehicle = {"coach.xml", line(2)};
  made.scenarios = {{"track.xml", line(3)}};
  Vary stiffness = test::range("secondary.stiffness_z", "500 kN/m", "900 kN/m", 5);
  stiffness.origin = line(4);
  Vary speed = test::list("speed", "80 km/h, 120 km/h");
  speed.origin = line(5);
  made.varies = {stiffness, speed};
  made.plan.emplace();
  made.plan->origin = line(6);
  made.designs = {{"light", "", {{"front_bogie.mass, rear_bogie.mass", "2 t", line(8)}}, line(7)}};
  made.metrics = {{"carbody.az.rms", line(9)}, {"secondary_front.deflection.peak", line(10)}};
  made.objectives = {{"carbody.az.rms", Goal::kMinimise, Over::kWorst, line(11)}};
  made.limits = {{"secondary_front.deflection.peak", "30 mm", "", line(12)}};
  return made;
}

std::string problemsAfter(const std::function<void(Study&)>& change) {
  Study made = springs();
  change(made);
  return check(made).text();
}

Study searching() {
  Study made = springs();
  made.plan.reset();
  made.varies[0].count.reset();
  made.search.emplace();
  made.search->origin = line(6);
  made.metrics.push_back({"carbody.z.peak", line(9)});
  made.objectives.push_back({"carbody.z.peak", Goal::kMinimise, Over::kWorst, line(10)});
  return made;
}

TEST(CheckStudy, WhatIsInOrderPasses) {
  EXPECT_EQ(check(springs()).text(), "");
  EXPECT_EQ(check(searching()).text(), "");
  for (const PlanKind kind : {PlanKind::kLatinHypercube, PlanKind::kSobol, PlanKind::kSaltelli}) {
    EXPECT_EQ(problemsAfter([kind](Study& made) {
                made.plan->kind = kind;
                made.plan->size = 1000;
                made.varies[0].count.reset();
              }),
              "");
  }
  EXPECT_EQ(problemsAfter([](Study& made) {
              made.plan->kind = PlanKind::kList;
              made.plan->file = "designs.csv";
              made.varies.erase(made.varies.begin());
            }),
            "");
}

struct Contradiction {
  std::function<void(Study&)> change;
  const char* says;
};

TEST(CheckStudy, EveryContradictionOfAPlanIsTold) {
  const std::vector<Contradiction> cases = {
      {[](Study& made) { made.vehicle.file.clear(); },
       "study.xml:1: error: <study>: has no <vehicle>; name one, e.g. <vehicle file=\"coach.xml\"/>\n"},
      {[](Study& made) { made.scenarios.push_back(made.scenarios[0]); },
       "study.xml:3: error: <study><scenario>: file=\"track.xml\" is listed twice (line 3); list it once\n"},
      {[](Study& made) { made.settle = -1.0; }, "study.xml:1: error: <study>: settle=\"-1 s\"; must be >= 0\n"},
      {[](Study& made) {
         made.settle = 2.0;
         made.evaluation = Evaluation::kSteadyState;
       },
       "study.xml:1: error: <study>: settle=\"2 s\" has no effect with evaluation=\"steady_state\", which has no start "
       "to leave out; remove settle, or take evaluation=\"run\"\n"},
      {[](Study& made) { made.plan->seed = 7; },
       "study.xml:6: error: <study><plan>: seed=\"7\" has no effect: a grid draws nothing; remove seed, or take a kind "
       "that samples: latin_hypercube, sobol, saltelli\n"},
      {[](Study& made) {
         made.varies.clear();
         made.designs.clear();
       },
       "study.xml:1: error: <study>: has no <vary> and no <design>; say what is compared: a study has at least one of "
       "them\n"},
      {[](Study& made) { made.varies[0].count.reset(); },
       "study.xml:4: error: <study><vary>: has no count; a grid needs the number of its steps, e.g. count=\"11\"\n"},
      {[](Study& made) { made.varies[0].values = "1 kN/m"; },
       "study.xml:4: error: <study><vary>: has a range and a list of values; give from and to, or values\n"},
      {[](Study& made) { made.varies[0].to.clear(); },
       "study.xml:4: error: <study><vary>: has no values; give from and to, or values=\"1 kN/m, 2 kN/m\"\n"},
      {[](Study& made) { made.varies[0].parameter = "a.x,, b.x"; },
       "study.xml:4: error: <study><vary>: parameter=\"a.x,, b.x\" has an empty item; put one comma between two "
       "parameters\n"},
      {[](Study& made) { made.varies[1].parameter = "speed, secondary.stiffness_z"; },
       "study.xml:5: error: <study><vary>: secondary.stiffness_z is varied already (line 4); vary it once\n"},
      {[](Study& made) { made.varies[1].values = "80 km/h,"; },
       "study.xml:5: error: <study><vary>: values=\"80 km/h,\" has an empty item; put one comma between two\n"},
      {[](Study& made) { made.plan->size = 7; },
       "study.xml:6: error: <study><plan>: has size; the counts of the ranges make the size of a grid\n"},
      {[](Study& made) { made.plan->kind = PlanKind::kSobol; },
       "study.xml:6: error: <study><plan>: has no size; say how many designs, e.g. size=\"1000\"\n"},
      {[](Study& made) {
         made.plan->kind = PlanKind::kSobol;
         made.plan->size = 8;
         made.varies.erase(made.varies.begin());
       },
       "study.xml:6: error: <study><plan>: has nothing to sample; add a <vary>; a speed with count or values is run by "
       "every design\n"},
      {[](Study& made) { made.plan->file = "designs.csv"; },
       "study.xml:6: error: <study><plan>: has file with another kind than list; write kind=\"list\", or remove "
       "file\n"},
      {[](Study& made) { made.plan->kind = PlanKind::kList; },
       "study.xml:6: error: <study><plan>: has no file; name the CSV file of the designs, e.g. file=\"designs.csv\"\n"
       "study.xml:6: error: <study><plan>: stands beside a <vary>; the columns of the file name what varies; remove "
       "the "
       "<vary>\n"},
  };
  for (const Contradiction& each : cases) EXPECT_EQ(problemsAfter(each.change), each.says);
}

TEST(CheckStudy, EveryContradictionOfDesignsMetricsAndGoalsIsTold) {
  const std::vector<Contradiction> cases = {
      {[](Study& made) { made.designs[0].name = "base"; },
       "study.xml:7: error: <study><design>: name=\"base\"; the vehicle as its file says it is called so; choose "
       "another "
       "name\n"},
      {[](Study& made) { made.designs.push_back(made.designs[0]); },
       "study.xml:7: error: <study><design>: name=\"light\" is already the name of a design (line 7); names are unique "
       "in "
       "a file\n"},
      {[](Study& made) { made.designs[0].sets.clear(); },
       "study.xml:7: error: <study><design>: sets nothing; add a <set>; the vehicle as it is is the design \"base\"\n"},
      {[](Study& made) {
         made.designs[0].sets.push_back({"rear_bogie.mass", "3 t", line(20)});
       },
       "study.xml:20: error: <study><design><set>: rear_bogie.mass is set already (line 8); set it once\n"},
      {[](Study& made) { made.designs[0].sets[0].parameter = "secondary.stiffness_z"; },
       "study.xml:8: error: <study><design><set>: secondary.stiffness_z is varied too (line 4), which would undo the "
       "design's value; vary it with kind=\"relative\", or not at all\n"},
      {[](Study& made) {
         made.varies[1].kind = Variation::kRelative;
         made.designs[0].sets[0].parameter = "speed";
       },
       "study.xml:8: error: <study><design><set>: speed is varied too (line 5), which would undo the design's value; "
       "vary "
       "it with kind=\"relative\", or not at all\n"},
      {[](Study& made) { made.metrics[1].name = "secondary_front.deflection.peek"; },
       "study.xml:10: error: <study><metric>: name=\"secondary_front.deflection.peek\" ends in \"peek\", which is no "
       "statistic; did you mean \"peak\"?\n"},
      {[](Study& made) { made.metrics.push_back(made.metrics[0]); },
       "study.xml:9: error: <study><metric>: name=\"carbody.az.rms\" is listed twice (line 9); list it once\n"},
      {[](Study& made) { made.objectives.push_back(made.objectives[0]); },
       "study.xml:11: error: <study><objective>: metric=\"carbody.az.rms\" has a goal already (line 11); give it "
       "one\n"},
      {[](Study& made) { made.limits[0].below.clear(); },
       "study.xml:12: error: <study><limit>: has no bound; give below, above or both\n"},
  };
  for (const Contradiction& each : cases) EXPECT_EQ(problemsAfter(each.change), each.says);
}

TEST(CheckStudy, ASearchHasObjectivesRangesAndAPopulationItsMethodCanUse) {
  const auto after = [](const std::function<void(Study&)>& change) {
    Study made = searching();
    change(made);
    return check(made).text();
  };
  EXPECT_EQ(
      after([](Study& made) { made.objectives.clear(); }),
      "study.xml:6: error: <study><search>: has no objective; a search weighs two or more; add <objective "
      "metric=\"...\" goal=\"minimise\"/>\n");
  EXPECT_EQ(
      after([](Study& made) { made.objectives.resize(1); }),
      "study.xml:6: error: <study><search>: has one objective; a search weighs two or more; add <objective "
      "metric=\"...\" goal=\"minimise\"/>\n");
  EXPECT_EQ(after([](Study& made) { made.search->population = 50; }),
            "study.xml:6: error: <study><search>: population=\"50\"; nsga2 needs a multiple of 4, at least 8\n");
  EXPECT_EQ(after([](Study& made) {
              made.search->method = SearchMethod::kNspso;
              made.search->population = 50;
            }),
            "");
  EXPECT_EQ(
      after([](Study& made) { made.varies[0].count = 3; }),
      "study.xml:4: error: <study><vary>: has steps beside a <search>; a search takes any value of a range: from and "
      "to alone\n");
  EXPECT_EQ(after([](Study& made) { made.varies.erase(made.varies.begin()); }),
            "study.xml:6: error: <study><search>: has nothing to vary; add a <vary> with from and to\n");
  EXPECT_EQ(after([](Study& made) {
              made.plan.emplace();
              made.plan->origin = line(13);
            }),
            "study.xml:13: error: <study><plan>: stands beside a <search>; a search chooses its designs itself; remove "
            "one of "
            "them\n");
}

TEST(ListedIn, ItemsLoseTheirSpacesAndEmptyOnesStay) {
  EXPECT_EQ(listedIn(" a b ,c,, "), (std::vector<std::string>{"a b", "c", "", ""}));
  EXPECT_EQ(listedIn(""), std::vector<std::string>{""});
}

}  // namespace
}  // namespace vehicle
