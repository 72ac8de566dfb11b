#include <string>

#include <gtest/gtest.h>

#include "libvehicle/xml/reader.h"
#include "libvehicle/xml/writer.h"
#include "tests/support/test_folder.h"
#include "tests/xml/files.h"

namespace vehicle {
namespace {

using test::Spoilt;
using test::withLine;

TEST(StudyReader, EveryWrongLineIsTold) {
  const std::vector<Spoilt> cases = {
      {2, "",
       R"(a.xml:1: error: <study>: element <vehicle> is missing; write e.g. <vehicle file="../vehicles/coach.xml"/>
)"},
      {3, "", "a.xml:1: error: <study>: has no <scenario>; a study has at least one\n"},
      {4, R"(<vary from="1 N/m" to="2 N/m" count="3"/>)",
       R"(a.xml:4: error: <study><vary>: attribute "parameter" is missing; write e.g. parameter="secondary.damping_z"
)"},
      {4, R"(<vary parameter="primary.stiffness_z" from="1 N/m" to="2 N/m"/>)",
       R"(a.xml:4: error: <study><vary>: has no count; a grid needs the number of its steps, e.g. count="11"
)"},
      {4, R"(<vary parameter="primary.stiffness_z" from="1 N/m" to="2 N/m" count="1"/>)",
       R"(a.xml:4: error: <study><vary>: count="1"; must be from 2 to 1000000
)"},
      {5, R"(<plan kind="sobol"/>)",
       "a.xml:5: error: <study><plan>: has no size; say how many designs, e.g. size=\"1000\"\n"},
      {5, R"(<plan kind="sobel" size="8"/>)",
       R"(a.xml:5: error: <study><plan>: kind="sobel" is none of "grid", "latin_hypercube", "sobol", "saltelli", "list"; did you mean "sobol"?
)"},
      {6, R"(<metric name=""/>)",
       R"(a.xml:6: error: <study><metric>: name="" is empty; write what it says, or leave the attribute out
)"},
      {7, R"(<objective metric="frame.az.rns" goal="minimise"/>)",
       R"(a.xml:7: error: <study><objective>: metric="frame.az.rns" is no <metric> of this study; did you mean "frame.az.rms"?
)"},
      {8, R"(<limit metric="frame.az.rms"/>)",
       "a.xml:8: error: <study><limit>: has no bound; give below, above or both\n"},
  };
  for (const Spoilt& each : cases) {
    const Outcome<Study> read = readStudyText(withLine(test::kStudyLines, each.line, each.instead), "a.xml");
    EXPECT_EQ(read.problems.text(), each.says) << each.instead;
    EXPECT_FALSE(read.value.has_value());
  }
}

constexpr const char* kEverything = R"xml(<study name="everything" format="1" settle="2 s">
  <title>All that may stand in a study</title>
  <vehicle file="../vehicles/coach.xml"/>

  <scenario file="a.xml"/>
  <scenario file="b.xml"/>

  <vary parameter="front.mass, rear.mass" kind="relative" from="80 %" to="1.2"/>
  <vary parameter="speed"                                                      values="80 km/h, 120 km/h"/>
  <plan kind="sobol" size="1024" seed="3"/>

  <design name="soft">
    <set parameter="secondary.stiffness_z" value="600 kN/m"/>
    <set parameter="secondary.damping_z"   value="30 kN*s/m"/>
  </design>

  <metric name="carbody.az.rms"/>
  <metric name="carbody.az.band(4..8 Hz)"/>

  <objective metric="carbody.az.rms" goal="minimise" over="mean"/>

  <limit metric="carbody.az.rms" below="0.3 m/s^2" above="0 m/s^2"/>
</study>
)xml";

TEST(StudyWriter, WhatIsReadIsWrittenAsItStood) {
  const Study study = readStudyText(kEverything, "a.xml").orThrow();
  EXPECT_EQ(study.settle, 2.0);
  ASSERT_EQ(study.varies.size(), 2u);
  EXPECT_EQ(study.varies[0].kind, Variation::kRelative);
  EXPECT_EQ(study.plan.value().kind, PlanKind::kSobol);
  EXPECT_EQ(study.designs.at(0).sets.size(), 2u);
  EXPECT_EQ(write(study), kEverything);
  std::string steady = kEverything;
  steady.replace(steady.find("settle=\"2 s\""), 12, "evaluation=\"steady_state\"");
  const Study other = readStudyText(steady, "a.xml").orThrow();
  EXPECT_EQ(other.evaluation, Evaluation::kSteadyState);
  EXPECT_EQ(write(other), steady);
}

TEST(StudyReader, TakesGoalsInEitherSpellingAndWritesOne) {
  for (const auto& [spelling, goal] :
       {std::pair{"minimize", Goal::kMinimise}, std::pair{"maximize", Goal::kMaximise}}) {
    std::string text = kEverything;
    text.replace(text.find("goal=\"minimise\""), 15, std::string("goal=\"") + spelling + '"');
    const Study study = readStudyText(text, "a.xml").orThrow();
    EXPECT_EQ(study.objectives.at(0).goal, goal);
    EXPECT_NE(write(study).find(goal == Goal::kMinimise ? "goal=\"minimise\"" : "goal=\"maximise\""),
              std::string::npos);
  }
}

}  // namespace
}  // namespace vehicle
