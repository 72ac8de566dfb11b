#include "libvehicle/project/check_file.h"

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/project/files.h"
#include "tests/support/source_tree.h"

namespace vehicle {
namespace {

using test::withLine;

/// Spoils a line of a file and tells all that is said about another one, or about itself.
class CheckFile : public ::testing::Test {
 protected:
  std::string problemsOf(const std::string& name) const {
    FileSource disk;
    return folder_.withoutFolder(checkFile(folder_.path(name), disk).problems.text());
  }
  std::string withStudyLine(int line, const std::string& instead) const {
    folder_.put("study.xml", withLine(test::kStudyLines, line, instead));
    return problemsOf("study.xml");
  }
  std::string withSuiteLine(int line, const std::string& instead) const {
    folder_.put("u.xml", withLine(test::kSuiteLines, line, instead));
    return problemsOf("u.xml");
  }
  std::string withList(const std::string& csv) const {
    folder_.put("list.csv", csv);
    test::Lines lines = test::kStudyLines;
    lines[3] = "";
    lines[4] = R"(<plan kind="list" file="list.csv"/>)";
    folder_.put("study.xml", test::textOf(lines));
    return problemsOf("study.xml");
  }
  test::ProjectFolder folder_;
};

TEST_F(CheckFile, FindsNothingInFilesThatAreRight) {
  for (const char* name : {"v.xml", "t.xml", "s.xml", "u.xml", "study.xml"}) EXPECT_EQ(problemsOf(name), "") << name;
}

TEST(ShippedModels, HaveNoProblems) {
  int count = 0;
  FileSource disk;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::sourcePath("models"))) {
    if (entry.path().extension() != ".xml") continue;
    ++count;
    const CheckedFile checked = checkFile(entry.path().string(), disk);
    EXPECT_EQ(checked.problems.text(), "");
    // The secondaries of the Pioneer cars come down by more than half a metre: that is true.
    for (const Warning& each : checked.warnings) {
      EXPECT_EQ(each.code, WarningCode::kRestDeflection) << each.text();
      EXPECT_NE(each.place.file.find("/pioneer-"), std::string::npos) << each.text();
    }
  }
  EXPECT_GE(count, 15);
}

// ---- studies

TEST_F(CheckFile, HoldsTheNamesOfAStudyAgainstItsVehicle) {
  EXPECT_EQ(withStudyLine(4, R"(<vary parameter="primary.stifness_z" from="2 MN/m" to="4 MN/m" count="3"/>)"),
            "study.xml:4: error: <study><vary>: parameter \"primary.stifness_z\" is unknown; "
            "did you mean \"primary.stiffness_z\"?\n");
  EXPECT_EQ(withStudyLine(4, R"(<vary parameter="frame.mass" from="2 MN/m" to="4 t" count="3"/>)"),
            "study.xml:4: error: <study><vary>: from=\"2 MN/m\" is a stiffness; a mass is expected, e.g. \"57 t\"\n");
}

TEST_F(CheckFile, ReportsAFileThatIsMissingOrOfAnotherKindWhereAStudyNamesIt) {
  EXPECT_EQ(withStudyLine(2, R"(<vehicle file="s.xml"/>)"),
            "study.xml:2: error: <study><vehicle>: file=\"s.xml\" holds a <scenario>; a <vehicle> is expected here\n");
  EXPECT_EQ(withStudyLine(3, R"(<scenario file="nowhere.xml"/>)"),
            "study.xml:3: error: <study><scenario>: file=\"nowhere.xml\": cannot be read: No such file or directory; "
            "check the name of the file\n");
  EXPECT_EQ(withStudyLine(3, R"(<scenario file="."/>)"),
            "study.xml:3: error: <study><scenario>: file=\".\": is a folder; name a file in it\n");
}

TEST_F(CheckFile, ReportsWhatIsWrongInsideANamedFileThereAllOfIt) {
  test::Lines vehicle = test::kVehicleLines;
  vehicle[2] = R"(<body name="frame" mass="-1 t" motion="z"/>)";
  vehicle[3] = R"(<wheelset name="axle" x="1 kg"/>)";
  folder_.put("v.xml", test::textOf(vehicle));
  folder_.put("s.xml", withLine(test::kScenarioLines, 4, R"(<harmonic wavelength="0 m" amplitude="5 mm"/>)"));
  EXPECT_EQ(problemsOf("study.xml"),
            "v.xml:3: error: <vehicle><body>: mass=\"-1 t\"; must be > 0\n"
            "v.xml:4: error: <vehicle><wheelset>: x=\"1 kg\" is a mass; a length is expected, e.g. \"3.725 m\"\n"
            "s.xml:4: error: <scenario><track><harmonic>: wavelength=\"0 m\"; must be > 0\n");
}

TEST_F(CheckFile, JudgesTheListOfDesignsWithItsLines) {
  EXPECT_EQ(withList("primary.stiffness_z [kN/m]\n3000\n4000\n"), "");
  EXPECT_EQ(withList("primary.stiffness_z [kg];nonsense\n-1;nan\n"),
            "list.csv:1: error: the fields are separated by \";\"; separate them by commas, and write decimals with a "
            "point: a header reads e.g. \"secondary.stiffness_z [kN/m],carbody.mass [t]\"\n");
  EXPECT_EQ(withList("primary.stiffness_z [kg],frame.mas [t]\n-1,nan\n1,2,3\n"),
            "list.csv:1: error: column \"primary.stiffness_z\": the unit [kg] is a mass; a stiffness is expected, e.g. "
            "\"3040 kN/m\"\n"
            "list.csv:1: error: parameter \"frame.mas\" is unknown; did you mean \"frame.mass\"?\n"
            "list.csv:2: error: column \"frame.mas\": \"nan\" is no number\n"
            "list.csv:3: error: the row has 3 fields, the header 2\n");
  std::filesystem::remove(folder_.path("list.csv"));
  EXPECT_EQ(
      problemsOf("study.xml"),
      "study.xml:5: error: <study><plan>: file=\"list.csv\": cannot be read: No such file or directory; check the "
      "name of the file\n");
  std::filesystem::create_directory(folder_.path("list.csv"));
  EXPECT_EQ(problemsOf("study.xml"),
            "study.xml:5: error: <study><plan>: file=\"list.csv\": is a folder; name a file in it\n");
}

TEST_F(CheckFile, CountsDesignsAndColumns) {
  EXPECT_EQ(withStudyLine(4, R"(<vary parameter="frame.mass" from="1 t" to="90 t" count="1000000"/>
  <vary parameter="primary.damping_z" from="1 N*s/m" to="9 N*s/m" count="1000000"/>)"),
            "study.xml:6: error: <study><plan>: makes more than 1000000000 designs, base and named ones counted; take "
            "fewer steps, or let latin_hypercube or sobol choose among them\n");
  // Four metrics at 500 speeds.
  std::string metrics;
  for (const char* name : {"frame.az.rms", "frame.az.peak", "frame.z.rms", "frame.z.peak"}) {
    metrics += std::string("<metric name=\"") + name + "\"/>";
  }
  test::Lines lines = test::kStudyLines;
  lines[3] += R"(<vary parameter="speed" from="20 km/h" to="120 km/h" count="500"/>)";
  lines[5] = metrics;
  folder_.put("study.xml", test::textOf(lines));
  EXPECT_EQ(
      problemsOf("study.xml"),
      "study.xml:1: error: the study makes 2001 columns (1 parameters, 2000 metrics over all speeds and scenarios), at "
      "most 1996 fit in a row; ask for fewer metrics or speeds, or make two studies\n");
  lines = test::kStudyLines;
  lines[3] = R"(<vary parameter="frame.mass" from="1 t" to="90 t"/>)";
  lines[4] = R"(<search method="nsga2" population="1000000" generations="1000000"/>)";
  lines[6] += R"(<metric name="frame.z.rms"/><objective metric="frame.z.rms" goal="minimise"/>)";
  folder_.put("study.xml", test::textOf(lines));
  EXPECT_EQ(
      problemsOf("study.xml"),
      "study.xml:5: error: <study><search>: makes 1000001000000 designs in 1000001 generations; at most 1000000000 "
      "are kept; take fewer generations or a smaller population\n");
}

TEST_F(CheckFile, RefusesASteadyStateOverADip) {
  folder_.put("s.xml",
              withLine(test::kScenarioLines, 4, R"(<dip shape="half_sine" depth="5 mm" length="3 m" start="20 m"/>)"));
  EXPECT_EQ(withStudyLine(1, R"(<study name="d" format="1" evaluation="steady_state">)"),
            "s.xml:1: error: <scenario>: has a dip, bump or ramp, which is met once: the study asks for the steady state; "
            "leave evaluation=\"steady_state\" out, or name a scenario of harmonics\n");
}

TEST_F(CheckFile, RefusesToSettleLongerThanTheRun) {
  EXPECT_EQ(withStudyLine(1, R"(<study name="d" format="1" settle="11 s">)"),
            "study.xml:1: error: <study>: settle=\"11 s\" leaves nothing of the run over \"s\", which lasts 10 s; settle "
            "less, or run longer\n");
}

// ---- suites

TEST_F(CheckFile, NamesUnknownFormsAndMethodsOfASuite) {
  EXPECT_EQ(withSuiteLine(5, R"(<form name="falt"/><form name="matrix"/><form name="finite-elements"/>)"),
            "u.xml:5: error: <suite><form>: form \"falt\" is unknown; did you mean \"flat\"?\n"
            "u.xml:5: error: <suite><form>: form \"finite-elements\" is unknown; choose one of flat, matrix, "
            "mbs-linear, mbs, flat-7-printed, flat-literal, flat-literal-mb\n");
  EXPECT_EQ(withSuiteLine(6, R"(<method name="rk5"/>)"),
            "u.xml:6: error: <suite><method>: method \"rk5\" is unknown; did you mean \"rk4\"?\n");
}

TEST_F(CheckFile, ReportsFilesThatASuiteCannotUse) {
  EXPECT_EQ(
      withSuiteLine(3, R"(<scenario file="v.xml"/> <scenario file="lost.xml"/>)"),
      "u.xml:3: error: <suite><scenario>: file=\"v.xml\" holds a <vehicle>; a <scenario> is expected here\n"
      "u.xml:3: error: <suite><scenario>: file=\"lost.xml\": cannot be read: No such file or directory; check the "
      "name of the file\n");
  EXPECT_EQ(withSuiteLine(2, R"(<vehicle file="t.xml"/>)"), "");
}

TEST_F(CheckFile, HoldsEveryVehicleOfASuiteAgainstEveryScenarioOnce) {
  folder_.put("rig.xml", test::withLine(test::kRigLines, 4,
                                        R"(<input wheelset="axel"><sine amplitude="6 mm" angular_frequency="5 rad/s"/>)"
                                        "</input>"));
  EXPECT_EQ(withSuiteLine(3, R"(<scenario file="s.xml"/> <scenario file="rig.xml"/>)"),
            "rig.xml:4: error: <scenario><rig><input>: wheelset=\"axel\" names no wheelset of the vehicle \"v\"; a rig "
            "drives wheelsets; did you mean \"axle\"?\n");
  folder_.put("jump.xml", test::withLine(test::kScenarioLines, 4,
                                         R"(<harmonic wavelength="25 m" amplitude="5 mm" phase="1 rad"/>)"));
  // At 14 speeds, said once.
  EXPECT_EQ(
      withSuiteLine(3, R"(<scenario file="jump.xml"/>)").find("jump.xml:4: error: <scenario><track><harmonic>: phase"),
      0u);
  EXPECT_EQ(withSuiteLine(3, R"(<scenario file="jump.xml"/>)").find('\n') + 1,
            withSuiteLine(3, R"(<scenario file="jump.xml"/>)").size());
}

TEST_F(CheckFile, RefusesHistoriesThatDoNotFitInMemory) {
  folder_.put("s.xml", test::withLine(test::kScenarioLines, 2,
                                      R"(<run speed="20 m/s" duration="1000 s" output_step="0.1 ms"/>)"));
  EXPECT_EQ(withSuiteLine(2, R"(<vehicle file="t.xml"/>)"), "");  // the reference alone
  test::Lines lines = test::withLines(test::kSuiteLines, 2, R"(<vehicle file="t.xml"/>)");
  lines[4] = R"(<form name="mbs"/>)";
  folder_.put("u.xml", test::textOf(lines));
  EXPECT_EQ(problemsOf("u.xml").find("s.xml:2: error: <scenario><run>: t: 2 runs of 10000001 samples need "), 0u)
      << problemsOf("u.xml");
}

TEST_F(CheckFile, WarnsOfASuiteThatJudgesNothing) {
  folder_.put("u.xml", test::withLine(test::kSuiteLines, 5, R"(<form name="flat"/>)"));
  FileSource disk;
  const CheckedFile checked = checkFile(folder_.path("u.xml"), disk);
  EXPECT_EQ(checked.problems.text(), "");
  ASSERT_EQ(checked.warnings.size(), 1u);
  const std::string text = folder_.withoutFolder(checked.warnings[0].text());
  EXPECT_EQ(text.find("u.xml:1: warning: u: nothing is judged: no two runs of a vehicle can be compared; v: flat: "),
            0u)
      << text;
  EXPECT_NE(text.find("; name a form and methods that can run it [NOTHING_JUDGED]"), std::string::npos) << text;
}

// ---- vehicles with scenarios

TEST_F(CheckFile, FindsAWeightThatTheSpringsCannotCarry) {
  folder_.put("v.xml", R"(<vehicle name="v" format="1">
  <element name="primary" stiffness_z="3040 kN/m"/>
  <body name="frame" mass="9 t" pitch_inertia="4 t*m^2" motion="z pitch"/>
  <wheelset name="axle" x="1 m"/>
  <suspension name="spring" element="primary" upper="frame" lower="axle" x="1 m"/>
</vehicle>
)");
  EXPECT_NE(problemsOf("v.xml"), "");
}

}  // namespace
}  // namespace vehicle
