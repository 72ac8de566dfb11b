#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/train.h"
#include "libvehicle/model/bound_study.h"
#include "libvehicle/xml/reader.h"
#include "tests/xml/files.h"

// Messages quote a value as its file has it, whichever check they come from.
namespace vehicle {
namespace {

using test::withLine;

TEST(Quoting, IsOfTheFilesOwnText) {
  struct Case {
    int line;
    const char* instead;
    const char* quotes;
  };
  const std::vector<Case> cases = {
      {2, R"(<run speed="0.0 km/h" duration="10 s"/>)", R"(speed="0.0 km/h"; must be > 0)"},
      {2, R"(<run speed="20 m/s" duration="0.100 ms" output_step="0.010 s"/>)",
       R"(output_step="0.010 s" is longer than the run, duration="0.100 ms")"},
      {2, R"(<run speed="72 km/h" distance="100 mm" output_step="0.010 s"/>)",
       R"(output_step="0.010 s" is longer than the run, distance="100 mm" at speed="72 km/h")"},
      {4, R"(<harmonic wavelength="25 m" amplitude="5 mm" phase="90 deg"/>)", R"(phase="90 deg" makes the rail jump)"},
      {4, R"(<dip shape="half_sine" depth="1 mm" length="2 m" start="-1000 mm"/>)", R"(start="-1000 mm" lies before)"},
      {4, R"(<harmonic wavelength="1e-70 km" amplitude="5 mm"/>)", R"(wavelength="1e-70 km"; must be at least)"},
  };
  for (const Case& each : cases) {
    const ProblemList problems =
        readScenarioText(withLine(test::kScenarioLines, each.line, each.instead), "a.xml").problems;
    ASSERT_EQ(problems.size(), 1u) << problems.text();
    EXPECT_NE(problems[0].text().find(each.quotes), std::string::npos) << problems.text();
    EXPECT_EQ(problems[0].place.line, each.line);
  }
}

TEST(Quoting, SaysWhereAValueIsADefault) {
  const std::string text = withLine(test::kScenarioLines, 2, R"(<run speed="20 m/s" duration="1 ms"/>)");
  EXPECT_EQ(
      readScenarioText(text, "a.xml").problems.text(),
      "a.xml:2: error: <scenario><run>: output_step=\"5 ms\" (default) is longer than the run, duration=\"1 ms\"; make "
      "it at most that\n");
}

TEST(Quoting, NamesTheAttributeThatStandsForSeveral) {
  const std::string text = withLine(test::kSuiteLines, 4, R"(<speed value="1e-70 km/h"/>)");
  const ProblemList problems = readSuiteText(text, "a.xml").problems;
  ASSERT_FALSE(problems.empty());
  EXPECT_NE(problems[0].text().find("value=\"1e-70 km/h\"; must be at least"), std::string::npos) << problems.text();
}

TEST(Quoting, LineIsThatOfTheAttribute) {
  const std::string text = withLine(test::kScenarioLines, 2, "<run\n    duration=\"10 s\"\n    speed=\"0.0 km/h\"/>");
  EXPECT_EQ(readScenarioText(text, "a.xml").problems.text(),
            "a.xml:4: error: <scenario><run>: speed=\"0.0 km/h\"; must be > 0\n");
}

TEST(Quoting, OfTrainsAndSuitesIsTheirOwnTextToo) {
  test::Lines suite = test::kSuiteLines;
  suite[3] = R"(<speed from="72 km/h" to="10 m/s" count="3"/>)";
  EXPECT_NE(readSuiteText(test::textOf(suite), "a.xml").problems.text().find("from=\"72 km/h\" is above to=\"10 m/s\""),
            std::string::npos);
  Train train =
      readTrainText(withLine(test::kTrainLines, 3, R"(<coupling end_x="12.5 m" z="1000 mm"/>)"), "t.xml").orThrow();
  for (TrainVehicle& each : train.vehicles) {
    each.vehicle = readVehicleText(test::textOf(test::kVehicleLines), "v.xml").orThrow();
  }
  EXPECT_NE(check(train).text().find("t.xml:3: error: <train><coupling>: z=\"1000 mm\", but"), std::string::npos);
}

// What a study sets stands in no vehicle file: it is formatted.
TEST(Quoting, FormatsWhatAStudySets) {
  const Vehicle vehicle = readVehicleText(test::textOf(test::kVehicleLines), "v.xml").orThrow();
  const Scenario scenario = readScenarioText(test::textOf(test::kScenarioLines), "s.xml").orThrow();
  const Study study =
      readStudyText(
          withLine(test::kStudyLines, 4, R"(<design name="d"><set parameter="frame.mass" value="-9000 kg"/></design>)"),
          "d.xml")
          .orThrow();
  EXPECT_EQ(bindStudy(study, vehicle, {scenario}).problems.text(),
            "d.xml:4: error: <study><design>: frame.mass = -9 t is not possible: mass=\"-9 t\"; must be > 0\n");
  // The vehicle as its file says it is still quoted as that.
  Vehicle wrong = vehicle;
  wrong.suspensions[0].upper = wrong.suspensions[0].lower;
  wrong.bodies[0].mass = -1.0;
  EXPECT_NE(check(wrong).text().find("mass=\"-1 kg\""), std::string::npos);
}

TEST(Quoting, OfAListNamesTheItem) {
  const std::string text =
      withLine(test::kStudyLines, 4, R"(<vary parameter="primary.stiffness_z" values="2 MN/m, 3 MM/m"/>)");
  const Vehicle vehicle = readVehicleText(test::textOf(test::kVehicleLines), "v.xml").orThrow();
  const Scenario scenario = readScenarioText(test::textOf(test::kScenarioLines), "s.xml").orThrow();
  const ProblemList problems = bindStudy(readStudyText(text, "d.xml").orThrow(), vehicle, {scenario}).problems;
  ASSERT_EQ(problems.size(), 1u) << problems.text();
  EXPECT_NE(problems[0].text().find("values=\"2 MN/m, 3 MM/m\": \"3 MM/m\" has the unknown unit \"MM\""),
            std::string::npos)
      << problems.text();
}

}  // namespace
}  // namespace vehicle
