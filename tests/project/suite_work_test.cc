#include "libvehicle/project/suite_work.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/project/files.h"
#include "tests/support/source_tree.h"

namespace vehicle {
namespace {

SuiteWork workOf(const test::ProjectFolder& folder, const ValidationChoice& choice = {}) {
  FileSource disk;
  return readSuiteWork(folder.path("u.xml"), choice, disk).orThrow();
}

TEST(SuiteWork, CrossesWhatTheSuiteNames) {
  const test::ProjectFolder folder;
  const SuiteWork work = workOf(folder);
  EXPECT_EQ(work.vehicles.size(), 1u);
  EXPECT_EQ(work.scenarios.size(), 1u);
  EXPECT_EQ(work.cases.size(), 14u);
  EXPECT_EQ(work.choice.forms, std::vector<std::string>{"matrix"});
}

TEST(SuiteWork, SpeedsThatAreChosenTakeThePlaceOfTheSuites) {
  const test::ProjectFolder folder;
  ValidationChoice choice;
  choice.speeds = {20.0, 30.0};
  const SuiteWork work = workOf(folder, choice);
  ASSERT_EQ(work.cases.size(), 2u);
  EXPECT_EQ(work.cases[0].speed, 20.0);
  EXPECT_EQ(work.cases[1].speed, 30.0);
}

TEST(UnjudgedOf, ASuiteWithFormsThatFitIsEmpty) {
  const test::ProjectFolder folder;
  folder.put("u.xml", test::withLine(test::kSuiteLines, 5, R"(<form name="matrix"/><form name="mbs-linear"/>)"));
  EXPECT_TRUE(unjudgedOf(workOf(folder)).empty());
}

TEST(UnjudgedOf, NamesTheVehicleThatNoFormFitsBesideOneThatIsJudged) {
  const test::ProjectFolder folder;
  folder.put("paper.xml", test::textOf(test::sourcePath("models/vehicles/al-oraiqat-2017.xml")));
  folder.put("u.xml", test::withLine(test::withLines(test::kSuiteLines, 5, R"(<form name="flat"/>)"), 2,
                                     R"(<vehicle file="v.xml"/> <vehicle file="paper.xml"/>)"));
  const Warnings warnings = unjudgedOf(workOf(folder));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].code, WarningCode::kNothingJudged);
  EXPECT_EQ(warnings[0].place.line, 2);
  EXPECT_EQ(warnings[0].subject, "v");
}

// The reference alone: no pair.
TEST(UnjudgedOf, OneRunIsNoComparison) {
  const test::ProjectFolder folder;
  EXPECT_EQ(unjudgedOf(workOf(folder)).size(), 1u);
}

}  // namespace
}  // namespace vehicle
