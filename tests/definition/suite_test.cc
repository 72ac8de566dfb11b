#include "libvehicle/definition/suite.h"

#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

Origin line(int number) {
  Origin origin;
  origin.file = "suite.xml";
  origin.line = number;
  return origin;
}

Suite paperSpeeds() {
  Suite made;
  made.name = "paper-speeds";
  made.origin = line(1);
  made.vehicles = {{"../vehicles/a.xml", line(2)}, {"../vehicles/b.xml", line(3)}};
  made.scenarios = {{"../scenarios/onset.xml", line(4)}};
  made.speeds = {{20.0 / 3.6, 150.0 / 3.6, 14, line(5)}};
  made.forms = {{"flat", line(6)}, {"mbs-linear", line(7)}};
  made.methods = {{"exact", line(8)}};
  return made;
}

std::string problemsAfter(const std::function<void(Suite&)>& change) {
  Suite made = paperSpeeds();
  change(made);
  return check(made).text();
}

TEST(SpeedsOf, FourteenSpeedsFrom20To150AreTenKilometresPerHourApart) {
  const std::vector<double> speeds = speedsOf(paperSpeeds());
  ASSERT_EQ(speeds.size(), 14u);
  EXPECT_EQ(speeds.front(), 20.0 / 3.6);
  EXPECT_EQ(speeds.back(), 150.0 / 3.6);
  // Three roundings of numbers below 42 m/s, 4e-15 each.
  for (std::size_t i = 0; i < 14; ++i) {
    EXPECT_WITHIN(speeds[i], (20.0 + 10.0 * static_cast<double>(i)) / 3.6, 2e-14);
  }
}

TEST(SpeedsOf, OneIsTheFirstTwoAreTheEndsAndRangesFollowEachOther) {
  Suite made;
  EXPECT_TRUE(speedsOf(made).empty());
  made.speeds = {{20.0, 30.0, 1, {}}, {10.0, 15.0, 2, {}}, {1.0, 2.0, 3, {}}};
  EXPECT_EQ(speedsOf(made), (std::vector<double>{20.0, 10.0, 15.0, 1.0, 1.5, 2.0}));
}

TEST(CheckSuite, WhatIsInOrderPasses) {
  EXPECT_EQ(check(paperSpeeds()).text(), "");
  EXPECT_EQ(problemsAfter([](Suite& made) {
              made.speeds.clear();
              made.forms.clear();
              made.methods.clear();
            }),
            "");
}

TEST(CheckSuite, HasANameVehiclesAndScenarios) {
  EXPECT_EQ(check(Suite{}).text(),
            "error: <suite>: has no name; name=\"...\" is required\n"
            "error: <suite>: has no <vehicle>; a suite has at least one\n"
            "error: <suite>: has no <scenario>; a suite has at least one\n");
}

TEST(CheckSuite, FilesAndNamesAreGivenAndListedOnce) {
  EXPECT_EQ(problemsAfter([](Suite& made) { made.vehicles[1].file = ""; }),
            "suite.xml:3: error: <suite><vehicle>: file is empty; name a file, e.g. file=\"../vehicles/coach.xml\"\n");
  EXPECT_EQ(problemsAfter([](Suite& made) { made.vehicles[1].file = "../vehicles/a.xml"; }),
            "suite.xml:3: error: <suite><vehicle>: file=\"../vehicles/a.xml\" is listed twice (line 2); "
            "list it once\n");
  EXPECT_EQ(problemsAfter([](Suite& made) { made.scenarios.push_back({"../scenarios/onset.xml", line(9)}); }),
            "suite.xml:9: error: <suite><scenario>: file=\"../scenarios/onset.xml\" is listed twice (line 4); "
            "list it once\n");
  EXPECT_EQ(problemsAfter([](Suite& made) { made.forms[1].name = "flat"; }),
            "suite.xml:7: error: <suite><form>: name=\"flat\" is listed twice (line 6); list it once\n");
  EXPECT_EQ(problemsAfter([](Suite& made) { made.methods[0].name = ""; }),
            "suite.xml:8: error: <suite><method>: has no name; name=\"...\" is required\n");
}

TEST(CheckSuite, SpeedsGoUpwardFromAPositiveOne) {
  const std::string speed = "suite.xml:5: error: <suite><speed>: ";
  const auto speedProblem = [](double from, double to, int count) {
    return problemsAfter([&](Suite& made) { made.speeds = {{from, to, count, line(5)}}; });
  };
  EXPECT_EQ(speedProblem(0.0, 20.0, 2), speed + "from=\"0 m/s\"; must be > 0\n");
  EXPECT_EQ(speedProblem(20.0, -1.0, 2), speed + "to=\"-1 m/s\"; must be > 0\n");
  EXPECT_EQ(speedProblem(20.0, 30.0, 0), speed + "count=\"0\"; must be 1..10000\n");
  EXPECT_EQ(speedProblem(20.0, 30.0, 2'000'000'000), speed + "count=\"2000000000\"; must be 1..10000\n");
  EXPECT_EQ(speedProblem(30.0, 20.0, 2),
            speed + "from=\"30 m/s\" is above to=\"20 m/s\"; speeds go from the lower to the higher\n");
  EXPECT_EQ(speedProblem(20.0, 20.0, 3),
            speed + "from and to are the same and count is 3; one speed has count=\"1\"\n");
  EXPECT_EQ(speedProblem(20.0, 20.0, 1), "");
}

}  // namespace
}  // namespace vehicle
