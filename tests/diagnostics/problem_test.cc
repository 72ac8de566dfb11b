#include "libvehicle/diagnostics/problem.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace vehicle {
namespace {

Problem problemAt(const std::string& file, int line, const std::string& message) {
  Problem problem;
  problem.place.file = file;
  problem.place.line = line;
  problem.message = message;
  return problem;
}

TEST(Problem, TextIsOneLineThatEditorsTurnIntoALink) {
  Problem problem = problemAt("coach.xml", 57, "wheelbase=\"-2.5 m\"");
  problem.element = "<bogie>";
  problem.remedy = "must be > 0";
  EXPECT_EQ(problem.text(), "coach.xml:57: error: <bogie>: wheelbase=\"-2.5 m\"; must be > 0");
}

TEST(Problem, TextLeavesOutWhatIsNotKnown) {
  EXPECT_EQ(problemAt("coach.xml", 0, "cannot be opened").text(), "coach.xml: error: cannot be opened");
  Problem problem = problemAt("", 0, "motion is empty");
  EXPECT_EQ(problem.text(), "error: motion is empty");
  problem.element = "<body>";
  EXPECT_EQ(problem.text(), "error: <body>: motion is empty");
}

TEST(ProblemList, SortsByFileAndLineAndKeepsTheOrderOfEquals) {
  ProblemList problems;
  problems.add(problemAt("b.xml", 1, "fourth"));
  problems.add(problemAt("a.xml", 7, "second"));
  problems.add(problemAt("a.xml", 3, "first"));
  problems.add(problemAt("a.xml", 7, "third"));
  problems.sortByPlace();
  EXPECT_EQ(problems.text(),
            "a.xml:3: error: first\n"
            "a.xml:7: error: second\n"
            "a.xml:7: error: third\n"
            "b.xml:1: error: fourth\n");
}

TEST(ProblemList, AppendsAnotherBehindItsOwn) {
  ProblemList first;
  ProblemList second;
  EXPECT_TRUE(first.empty());
  first.add(problemAt("", 0, "one"));
  second.add(problemAt("", 0, "two"));
  first.append(second);
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[1].message, "two");
}

TEST(Outcome, GivesItsValueOnlyWithoutProblems) {
  Outcome<int> good{7, {}};
  EXPECT_TRUE(good.ok());
  EXPECT_EQ(std::move(good).orThrow(), 7);

  Outcome<int> doubtful{7, {}};
  doubtful.problems.add(problemAt("a.xml", 2, "wrong"));
  EXPECT_FALSE(doubtful.ok());
  try {
    (void)std::move(doubtful).orThrow();
    FAIL() << "orThrow() gave a value";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "a.xml:2: error: wrong\n");
    EXPECT_EQ(error.problems().size(), 1u);
  }
}

TEST(NearestName, IsWithinAThirdOfTheWordAndAtLeastOneEdit) {
  const std::vector<std::string> names = {"mass", "motion", "pitch_inertia", "x"};
  EXPECT_EQ(nearestName("mas", names), "mass");
  EXPECT_EQ(nearestName("masss", names), "mass");
  EXPECT_EQ(nearestName("motoin", names), "motion");
  EXPECT_EQ(nearestName("pitchinertia", names), "pitch_inertia");
  EXPECT_EQ(nearestName("pitch_inretai", names), "pitch_inertia");
  EXPECT_EQ(nearestName("y", names), "x");
  EXPECT_EQ(nearestName("stiffness", names), std::nullopt);
  EXPECT_EQ(nearestName("massive", names), std::nullopt);
  EXPECT_EQ(nearestName("mass", {}), std::nullopt);
}

TEST(NearestName, OfEquallyNearOnesIsTheFirst) {
  EXPECT_EQ(nearestName("primary_5", {"primary_1", "primary_2"}), "primary_1");
}

TEST(NearestName, TwoLettersExchangedAreOneSlip) {
  EXPECT_EQ(nearestName("falt", {"matrix", "flat", "mbs"}), "flat");
  EXPECT_EQ(nearestName("axel", {"axle"}), "axle");
  EXPECT_EQ(nearestName("eaxl", {"axle"}), std::nullopt);
}

}  // namespace
}  // namespace vehicle
