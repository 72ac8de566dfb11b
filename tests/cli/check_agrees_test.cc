// What `check` finds is what the command that takes the file refuses it for: the same lines, and none that it would
// not.
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/cli/studies.h"

namespace vehicle::test {
namespace {

/// A folder with v.xml, s.xml, rig.xml, dip.xml, paper.xml (a link to the shipped vehicle), and one file under test.
class CheckAgrees : public ::testing::Test {
 protected:
  CheckAgrees() {
    folder_.file("v.xml", smallVehicle());
    folder_.file("s.xml", smallScenario(R"(speed="20 m/s" duration="1 s" output_step="5 ms")"));
    folder_.file("rig.xml", R"(<scenario name="rig" format="1">
  <run duration="1 s"/>
  <rig><input wheelset="axle_7"><sine amplitude="6 mm" angular_frequency="5 rad/s"/></input></rig>
</scenario>
)");
    folder_.file("dip.xml", R"(<scenario name="dip" format="1">
  <run speed="20 m/s" duration="1 s"/>
  <track history="onset"><dip shape="half_sine" depth="5 mm" length="3 m" start="5 m"/></track>
</scenario>
)");
    folder_.file("start.xml", R"(<scenario name="start" format="1">
  <run speed="20 m/s" duration="1 s"/>
  <track history="onset"><harmonic wavelength="25 m" amplitude="5 mm"/></track>
  <initial_state><body name="bogie" z="1 mm"/></initial_state>
</scenario>
)");
    folder_.file("t.xml", R"(<train name="t" format="1"><vehicle file="v.xml" count="2" spacing="20 m"/></train>)");
  }

  /// `arguments` take the file that `check` judges.
  void expectAgreement(const std::vector<std::string>& checked, const std::vector<std::string>& arguments) {
    std::vector<std::string> words = {"check"};
    words.insert(words.end(), checked.begin(), checked.end());
    const ProgramRun check = runVehicle(words);
    const ProgramRun taken = runVehicle(arguments);
    std::string problems;
    for (const std::string& line : linesOf(check.out)) {
      if (!line.ends_with(": ok")) problems += line + "\n";
    }
    if (check.status == 0) {
      EXPECT_EQ(problems, "");
      EXPECT_NE(taken.status, 1) << taken.err;
      EXPECT_NE(taken.status, 2) << taken.err;
    } else {
      EXPECT_EQ(check.status, 1) << check.out << check.err;
      EXPECT_EQ(taken.status, 1) << taken.out << taken.err;
      EXPECT_EQ(taken.err, problems);
    }
    found_ += check.status == 0 ? 0 : 1;
  }

  TestFolder folder_;
  int found_ = 0;  // files with problems
};

TEST_F(CheckAgrees, AboutStudies) {
  const std::string files = R"(<vehicle file="v.xml"/><scenario file="s.xml"/>)";
  const std::string vary = R"(<vary parameter="spring.stiffness_z" from="1 MN/m" to="2 MN/m" count="2"/>)";
  const std::string list = files + R"(<plan kind="list" file="designs.csv"/>)";
  const struct {
    std::string middle, attributes, csv;
  } cases[] = {
      {files + vary, "", ""},
      {files + R"(<vary parameter="spring.stifness_z" from="1 MN/m" to="2 MN/m" count="2"/>)", "", ""},
      {files + R"(<vary parameter="spring.stiffness_z" from="1 kg" to="2 MN/m" count="2"/>)", "", ""},
      {R"(<vehicle file="lost.xml"/><scenario file="s.xml"/>)" + vary, "", ""},
      {R"(<vehicle file="."/><scenario file="s.xml"/>)" + vary, "", ""},
      {R"(<vehicle file="s.xml"/><scenario file="v.xml"/>)" + vary, "", ""},
      {R"(<vehicle file="v.xml"/><scenario file="rig.xml"/>)" + vary, "", ""},
      {R"(<vehicle file="v.xml"/><scenario file="start.xml"/>)" + vary, "", ""},
      {R"(<vehicle file="v.xml"/><scenario file="dip.xml"/>)" + vary, R"(evaluation="steady_state")", ""},
      {R"(<vehicle file="v.xml"/><scenario file="dip.xml"/>)" + vary, "", ""},
      {files + vary, R"(settle="2 s")", ""},
      {files + vary, R"(settle="999.9 ms")", ""},
      {list, "", "spring.stiffness_z [kN/m]\n900\n1100\n"},
      {list, "", "spring.stiffness_z [kg];nonsense\n-1;nan\n"},
      {list, "", "spring.stifness_z [kN/m],carbody.mass [kN]\n1,x\n1\n"},
      {list, "", "spring.stiffness_z [kN/m]\n"},
      {list, "", ""},
      {list + R"(<design name="light"><set parameter="spring.stiffness_z" value="1 MN/m"/></design>)", "",
       "spring.stiffness_z [kN/m]\n900\n"},
      {files + R"(<plan kind="list" file="lost.csv"/>)", "", ""},
      {files + R"(<plan kind="list" file="."/>)", "", ""},
      {files + R"(<vary parameter="spring.stiffness_z" from="1 MN/m" to="2 MN/m" count="1000000"/>)" +
           R"(<vary parameter="carbody.mass" from="1 t" to="2 t" count="1000000"/>)",
       "", ""},
      {files + R"(<vary parameter="speed" from="20 km/h" to="120 km/h" count="2000"/>)" + vary, "", ""},
      {files + R"(<vary parameter="spring.stiffness_z" from="1 MN/m" to="2 MN/m"/>)" +
           R"(<plan kind="saltelli" size="2000000000"/>)",
       "", ""},
      {files + R"(<vary parameter="spring.stiffness_z" from="1 MN/m" to="2 MN/m"/>)" +
           R"(<search method="nsga2" population="9" generations="1"/>)",
       "", ""},
      {files + R"(<vary parameter="spring.stiffness_z" from="1 MN/m" to="2 MN/m"/>)" +
           R"(<search method="nspso" population="1000000" generations="1000000"/>)" +
           R"(<metric name="carbody.z.peak"/><objective metric="carbody.z.peak" goal="minimise"/>)",
       "", ""},
      {files + vary + R"(<metric name="axle.az.rms"/>)", "", ""},
  };
  int number = 0;
  for (const auto& each : cases) {
    SCOPED_TRACE(each.middle + " " + each.attributes + " " + each.csv);
    std::filesystem::remove(folder_.path("designs.csv"));
    if (!each.csv.empty()) folder_.file("designs.csv", each.csv);
    const std::string study =
        folder_.file("study.xml", "<study name=\"s\" format=\"1\" " + each.attributes + ">\n  " + each.middle +
                                      "\n  <metric name=\"carbody.az.rms\"/>\n"
                                      "  <objective metric=\"carbody.az.rms\" goal=\"minimise\"/>\n"
                                      "</study>\n");
    const std::string database = folder_.path(std::to_string(++number).append(".sqlite"));
    expectAgreement({study}, {"study", study, "--output", database, "--quiet"});
  }
  EXPECT_GE(found_, 18);
}

TEST_F(CheckAgrees, AboutSuites) {
  const std::string pair = R"(<vehicle file="v.xml"/><scenario file="s.xml"/>)";
  const std::string cases[] = {
      pair + R"(<form name="matrix"/><form name="mbs-linear"/>)",
      pair + R"(<form name="falt"/><method name="rk5"/>)",
      pair + R"(<form name="flat"/>)",  // does not fit: nothing is judged, which is no fault of the file
      R"(<vehicle file="v.xml"/><vehicle file="lost.xml"/><scenario file="s.xml"/>)",
      R"(<vehicle file="v.xml"/><scenario file="."/>)",
      R"(<vehicle file="s.xml"/><scenario file="v.xml"/>)",
      R"(<vehicle file="v.xml"/><vehicle file="t.xml"/><scenario file="s.xml"/><scenario file="rig.xml"/>)",
      R"(<vehicle file="v.xml"/><scenario file="start.xml"/><speed from="10 m/s" to="20 m/s" count="5"/>)",
      R"(<vehicle file="v.xml"/><scenario file="long.xml"/>)",
      R"(<vehicle file="v.xml"/><scenario file="s.xml"/><speed from="20 m/s" to="10 m/s" count="5"/>)",
  };
  folder_.file("long.xml", smallScenario(R"(speed="20 m/s" duration="9000 s" output_step="1 ms")"));
  for (const std::string& each : cases) {
    SCOPED_TRACE(each);
    const std::string suite = folder_.file("suite.xml", "<suite name=\"u\" format=\"1\">\n  " + each + "\n</suite>\n");
    expectAgreement({suite}, {"validate", suite, "--quiet"});
  }
  EXPECT_EQ(found_, 8);
}

TEST_F(CheckAgrees, AboutVehiclesTrainsAndScenarios) {
  const std::string right = folder_.path("v.xml"), scenario = folder_.path("s.xml");
  const std::string cases[][2] = {
      {right, scenario},
      {right, folder_.path("rig.xml")},
      {right, folder_.path("start.xml")},
      {right, folder_.path("dip.xml")},
      {right, folder_.path("lost.xml")},
      {right, folder_.root().string()},
      {folder_.path("t.xml"), scenario},
      {folder_.file("t2.xml",
                    R"(<train name="t" format="1"><vehicle file="lost.xml" count="2" spacing="20 m"/></train>)"),
       scenario},
      {folder_.file("v2.xml", with(smallVehicle(), "10 t", "-10 t")), scenario},
      {right, folder_.file("s2.xml", with(smallScenario(R"(speed="20 m/s" duration="1 s")"), "25 m", "0 m"))},
      {right, folder_.file("s3.xml", with(smallScenario(R"(speed="20 m/s" duration="1 s")"),
                                          "amplitude=", "phase=\"1 rad\" amplitude="))},
  };
  for (const auto& [vehicle, track] : cases) {
    SCOPED_TRACE(vehicle + " " + track);
    expectAgreement({vehicle, track}, {"simulate", vehicle, track, "--quiet"});
  }
  EXPECT_GE(found_, 7);
}

TEST_F(CheckAgrees, ThatASuiteInWhichNothingRunsIsNoPass) {
  const std::string suite = folder_.file("suite.xml", R"(<suite name="u" format="1">
  <vehicle file="v.xml"/> <scenario file="s.xml"/> <form name="flat"/>
</suite>
)");
  const ProgramRun check = runVehicle({"check", suite});
  EXPECT_EQ(check.status, 0);
  EXPECT_EQ(check.err.rfind(suite + ":1: warning: u: nothing is judged: ", 0), 0u) << check.err;
  EXPECT_EQ(linesOf(check.err).size(), 1u) << check.err;
  EXPECT_EQ(runVehicle({"check", suite, "--strict"}).status, 4);
  const ProgramRun validate = runVehicle({"validate", suite});
  EXPECT_EQ(validate.status, 4);
  EXPECT_EQ(validate.err, check.err);
  EXPECT_EQ(runVehicle({"validate", suite, "--allow-unjudged"}).status, 4);
}

}  // namespace
}  // namespace vehicle::test
