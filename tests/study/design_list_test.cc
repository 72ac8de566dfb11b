#include "libvehicle/study/plan/design_list.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/study/studies.h"

namespace vehicle {
namespace {

using test::studyOf;
using test::valuesOf;

Outcome<DesignPlan> planFrom(const std::string& text, const Study& study) {
  const Outcome<ListedColumns> columns = listedColumns(text, "list.csv");
  ProblemList problems = columns.problems;
  Outcome<BoundStudy> bound = bindStudy(study, test::paperVehicle(), {test::waves()}, *columns.value);
  problems.append(bound.problems);
  if (!problems.empty()) return {std::nullopt, problems};
  Outcome<DesignList> list = readDesignList(text, "list.csv", *bound.value);
  if (!list.value) return {std::nullopt, list.problems};
  return DesignPlan::of(study, *bound.value, *list.value);
}

TEST(DesignList, RowsBecomeDesignsInTheUnitsOfTheHeader) {
  Study study = studyOf({}, PlanKind::kList);
  study.plan->file = "list.csv";
  study.designs = {{"light", "", {{"front_bogie.mass", "7 t", {}}}, {}}};
  EXPECT_EQ(check(study).text(), "");
  const DesignPlan plan =
      planFrom("\xEF\xBB\xBFsecondary.stiffness_z [kN/m],\"scenario.wave.amplitude [mm]\"\r\n600,9\r\n8.6e2, 7.1\n\n",
               study)
          .orThrow();
  ASSERT_EQ(plan.size(), 2u + 2u * 2u);
  // 9 mm is the double nearest to 0.009, as everywhere.
  EXPECT_EQ(valuesOf(plan, 0), (std::vector<double>{2660e3, 0.005, 9e3}));
  EXPECT_EQ(valuesOf(plan, 2), (std::vector<double>{600e3, 0.009, 9e3}));
  EXPECT_EQ(valuesOf(plan, 3), (std::vector<double>{860e3, 0.0071, 9e3}));
  EXPECT_EQ(valuesOf(plan, 5), (std::vector<double>{860e3, 0.0071, 7e3}));
}

TEST(DesignList, BlanksAboutNamesAndNumbersCountForNothing) {
  Study study = studyOf({}, PlanKind::kList);
  study.plan->file = "list.csv";
  const DesignPlan plan =
      planFrom("secondary.stiffness_z [kN/m], carbody.mass [t]\n 600, 50\n\t700 ,60 \n", study).orThrow();
  ASSERT_EQ(plan.size(), 3u);
  EXPECT_EQ(valuesOf(plan, 1), (std::vector<double>{600e3, 50e3}));
  EXPECT_EQ(valuesOf(plan, 2), (std::vector<double>{700e3, 60e3}));
}

TEST(DesignList, EveryWrongLineIsTold) {
  Study study = studyOf({}, PlanKind::kList);
  study.plan->file = "list.csv";
  const auto problems = [&](const std::string& text) { return planFrom(text, study).problems.text(); };
  EXPECT_EQ(problems("carbody.mass\n1\n"),
            "list.csv:1: error: column \"carbody.mass\" has no name with a unit in brackets; a header reads e.g. "
            "\"secondary.stiffness_z [kN/m],carbody.mass [t]\"\n");
  EXPECT_EQ(problems("carbody.mass [t],carbody.mass [t]\n1,1\n"),
            "list.csv:1: error: column \"carbody.mass\" stands there twice\n");
  EXPECT_EQ(problems("carbody.mas [t]\n1\n"),
            "list.csv:1: error: parameter \"carbody.mas\" is unknown; did you mean \"carbody.mass\"?\n");
  EXPECT_EQ(
      problems("carbody.mass [m]\n1\n"),
      "list.csv:1: error: column \"carbody.mass\": the unit [m] is a length; a mass is expected, e.g. \"57 t\"\n");
  EXPECT_EQ(problems("carbody.mass [t]\n1\nheavy\n2,3\nnan\n"),
            "list.csv:3: error: column \"carbody.mass\": \"heavy\" is no number\n"
            "list.csv:4: error: the row has 2 fields, the header 1\n"
            "list.csv:5: error: column \"carbody.mass\": \"nan\" is no number\n");
  // One pass finds what is wrong with names, units and numbers alike.
  EXPECT_EQ(problems("carbody.mas [t],primary.stiffness_z [kg]\n1,2\nx,y\n"),
            "list.csv:3: error: column \"carbody.mas\": \"x\" is no number\n"
            "list.csv:3: error: column \"primary.stiffness_z\": \"y\" is no number\n"
            "list.csv:1: error: parameter \"carbody.mas\" is unknown; did you mean \"carbody.mass\"?\n"
            "list.csv:1: error: column \"primary.stiffness_z\": the unit [kg] is a mass; a stiffness is expected, e.g. "
            "\"3040 kN/m\"\n");
  EXPECT_EQ(problems("carbody.mass [t];primary.stiffness_z [kN/m]\n50;3000\n"),
            "list.csv:1: error: the fields are separated by \";\"; separate them by commas, and write decimals with a "
            "point: a header reads e.g. \"secondary.stiffness_z [kN/m],carbody.mass [t]\"\n");
  EXPECT_EQ(problems("carbody.mass [t]\n1e308\n"),
            "list.csv:2: error: column \"carbody.mass\": \"1e308\" is no number\n");
  EXPECT_EQ(problems("carbody.mass [t]\n"), "list.csv: error: holds no design; write one a row under the header\n");
  study.designs = {{"light", "", {{"carbody.mass", "7 t", {}}}, {}}};
  EXPECT_EQ(
      problems("carbody.mass [t]\n1\n"),
      "error: <study><design>: sets carbody.mass, which the list of designs gives too; leave it out of one of them\n");
}

}  // namespace
}  // namespace vehicle
