#include "libvehicle/project/settings.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/project/check_file.h"
#include "libvehicle/project/model.h"
#include "libvehicle/project/study_work.h"
#include "libvehicle/project/suite_work.h"
#include "libvehicle/simulate/simulate.h"
#include "tests/project/files.h"

namespace vehicle {
namespace {

using Texts = std::vector<std::string>;

Model modelOf(const test::ProjectFolder& folder, const std::string& vehicle, const std::string& scenario,
              const Texts& settings = {}) {
  FileSource disk;
  return readModel(folder.path(vehicle), folder.path(scenario), disk, Settings(settings));
}

/// A vehicle whose wheelsets stand in a group, as a file that gives these values.
std::string groupedVehicle(const std::string& stiffness, const std::string& mass, const std::string& place) {
  return R"(<vehicle name="v" format="1">
  <element name="primary" stiffness_z=")" +
         stiffness + R"(" damping_z="30 kN*s/m"/>
  <body name="frame" mass=")" +
         mass + R"(" pitch_inertia="3 t*m^2" motion="z pitch"/>
  <group name="front" x=")" +
         place + R"(">
    <wheelset name="axle_1" x="0.31 m"/>
    <suspension name="spring_1" element="primary" upper="frame" lower="axle_1" x="0.31 m"/>
  </group>
  <wheelset name="axle_2" x="-1.2 m"/>
  <suspension name="spring_2" element="primary" upper="frame" lower="axle_2" x="-1.2 m"/>
</vehicle>
)";
}

std::string trackOf(const std::string& amplitude, const std::string& phase) {
  return test::withLine(
      test::kScenarioLines, 4,
      "<harmonic name=\"wave\" wavelength=\"25 m\" amplitude=\"" + amplitude + "\" phase=\"" + phase + "\"/>");
}

// A value set is a value that the file gives: the same structs, and a run of the same bits. The numbers are none that a
// double holds.
TEST(Settings, GiveTheBitsOfAFileEditedByHand) {
  const test::ProjectFolder folder;
  folder.put("v.xml", groupedVehicle("3040 kN/m", "9 t", "1.5 m"));
  folder.put("s.xml", trackOf("5 mm", "0 rad"));
  folder.put("edited-v.xml", groupedVehicle("2.7 MN/m", "8.9 t", "1.3 m"));
  folder.put("edited-s.xml",
             R"(<scenario name="s" format="1" gravity="9.7 m/s^2">
  <run speed="93.7 km/h" duration="1.1 s" output_step="5 ms"/>
  <track history="onset"> <harmonic name="wave" wavelength="25 m" amplitude="3.3 mm"/> </track>
</scenario>
)");
  const Model set = modelOf(
      folder, "v.xml", "s.xml",
      {"primary.stiffness_z=2.7 MN/m", " frame.mass = 8.9 t ", "front.x=1.3 m", "scenario.wave.amplitude=3.3 mm",
       "scenario.gravity=9.7 m/s^2", "speed=93.7 km/h", "scenario.duration=1.1 s"});
  const Model edited = modelOf(folder, "edited-v.xml", "edited-s.xml");
  EXPECT_EQ(set.vehicle.vehicle, edited.vehicle.vehicle);
  EXPECT_EQ(set.scenario, edited.scenario);
  const RunResult of_set = simulate(set.vehicle, set.scenario, {});
  const RunResult of_edited = simulate(edited.vehicle, edited.scenario, {});
  ASSERT_EQ(of_set.history.samples(), of_edited.history.samples());
  EXPECT_GT(of_set.history.samples(), 200u);
  for (std::size_t column = 0; column < of_set.history.columns().size(); ++column) {
    EXPECT_EQ(of_set.history.column(column), of_edited.history.column(column));
  }
  ASSERT_EQ(set.settings.size(), 7u);
  EXPECT_EQ(set.settings[1].address + '|' + set.settings[1].value, "frame.mass|8.9 t");
}

TEST(Settings, OfATrainAreThoseOfOneUnitOrOfTheCouplings) {
  const test::ProjectFolder folder;
  folder.put("w.xml", R"(<vehicle name="v" format="1">
  <element name="primary" stiffness_z="3040 kN/m" damping_z="33.3 kN*s/m"/>
  <body name="frame" mass="8.7 t" motion="z"/>
  <wheelset name="axle" x="1 m"/>
  <suspension name="spring" element="primary" upper="frame" lower="axle" x="1 m"/>
</vehicle>
)");
  folder.put("edited.xml", R"(<train name="t" format="1">
  <vehicle file="v.xml" spacing="26 m"/>
  <vehicle file="w.xml" spacing="26 m"/>
  <vehicle file="v.xml" spacing="26 m"/>
  <coupling stiffness_z="61.7 kN/m" damping_z="20 kN*s/m" end_x="12.5 m"/>
</train>
)");
  const Model set =
      modelOf(folder, "t.xml", "s.xml",
              {"v_2.frame.mass=8.7 t", "v_2.primary.damping_z=33.3 kN*s/m", "coupling.stiffness_z=61.7 kN/m"});
  EXPECT_EQ(set.vehicle.vehicle, modelOf(folder, "edited.xml", "s.xml").vehicle.vehicle);
}

TEST(Settings, MayGiveWhatTheFileLeavesOutAndWhatOnlyTogetherIsRight) {
  const test::ProjectFolder folder;
  const Model model = modelOf(folder, "v.xml", "s.xml",
                              {"axle.contact_stiffness=1 GN/m", "axle.mass=1.8 t", "axle.contact_damping=0 N*s/m"});
  EXPECT_EQ(model.vehicle.vehicle.wheelsets[0].mass, 1800.0);
  EXPECT_TRUE(hasOwnMotion(model.vehicle.vehicle.wheelsets[0]));
}

/// What is wrong with settings of v.xml and s.xml.
std::string refusalOf(const Texts& settings, const char* scenario = "s.xml") {
  const test::ProjectFolder folder;
  folder.put("rig.xml", test::textOf(test::kRigLines));
  try {
    static_cast<void>(modelOf(folder, "v.xml", scenario, settings));
  } catch (const std::invalid_argument& wrong) {
    return wrong.what();
  }
  return "";
}

TEST(Settings, EveryMistakeIsOneLineThatNamesItsOption) {
  struct Case {
    const char* setting;
    const char* refusal;
  };
  const Case cases[] = {
      {"primry.stiffness_z=1 kN/m",
       R"(parameter "primry.stiffness_z" is unknown; did you mean "primary.stiffness_z"?)"},
      {"frame.colour=1 m",
       R"(parameter "frame.colour" is unknown; write PART.ATTRIBUTE; it has frame.mass, frame.pitch_inertia, frame.x, frame.z)"},
      {"frame.mass=9", R"("9" has no unit; a mass is expected, e.g. "57 t")"},
      {"primary.stiffness_z=9 kN*s/m", R"("9 kN*s/m" is a damping; a stiffness is expected, e.g. "3040 kN/m")"},
      {"frame.mass=-9 t", R"(<vehicle><body>: mass="-9 t"; must be > 0)"},
      {"primary.damping_z=-1 N*s/m", R"(<vehicle><element>: damping_z="-1 N*s/m"; must be >= 0)"},
      {"scenario.output_step=0 s", R"(<scenario><run>: output_step="0 s"; must be > 0)"},
      {"scenario.distance=100 m", "<scenario><run>: has duration and distance; give one of them"},
      {"axle.contact_stiffness=1 GN/m",
       "<vehicle><wheelset>: has contact_stiffness but no mass; give its mass, or leave the contact out: then it "
       "follows "
       "the rail"},
      {"frame.mass",
       "gives no value; write PART.ATTRIBUTE=VALUE with its unit, e.g. --set "
       "\"secondary.stiffness_z=600 kN/m\""},
      {"= 9 t",
       "names no parameter; write PART.ATTRIBUTE=VALUE with its unit, e.g. --set "
       "\"secondary.stiffness_z=600 kN/m\""},
  };
  for (const Case& each : cases) {
    EXPECT_EQ(refusalOf({each.setting}), "--set \"" + std::string(each.setting) + "\": " + each.refusal);
  }
  EXPECT_EQ(refusalOf({"speed=30 m/s"}, "rig.xml"),
            "--set \"speed=30 m/s\": has no effect: no wheel rolls on a rig with a duration; omit it");
  EXPECT_EQ(refusalOf({"frame.mass=8 t", "frame.mass=9 t"}),
            "--set \"frame.mass=9 t\": frame.mass is set already, by --set \"frame.mass=8 t\"; set it once");
}

TEST(Settings, AllMistakesComeAtOnceAndThoseOfSeveralNameThemAll) {
  EXPECT_EQ(refusalOf({"frame.mass=9", "scenario.gravty=9 m/s^2", "primary.damping_z=-1 N*s/m"}),
            "--set \"frame.mass=9\": \"9\" has no unit; a mass is expected, e.g. \"57 t\"\n"
            "--set \"scenario.gravty=9 m/s^2\": parameter \"scenario.gravty\" is unknown; did you mean "
            "\"scenario.gravity\"?\n"
            "--set \"primary.damping_z=-1 N*s/m\": <vehicle><element>: damping_z=\"-1 N*s/m\"; must be >= 0");
  EXPECT_EQ(
      refusalOf({"axle.mass=1 t", "axle.contact_stiffness=1 GN/m", "axle.hertz_constant=90 GN/m^1.5"}),
      "--set \"axle.mass=1 t\", --set \"axle.contact_stiffness=1 GN/m\", --set \"axle.hertz_constant=90 "
      "GN/m^1.5\": <vehicle><wheelset>: has contact_stiffness and hertz_constant; give one of them: the contact is "
      "linear or Hertz's");
}

TEST(Settings, OfAScenarioAreRefusedWhereNoneIsRead) {
  const test::ProjectFolder folder;
  FileSource disk;
  Settings settings({"scenario.gravity=9 m/s^2", "speed=20 m/s"});
  static_cast<void>(checkFile(folder.path("v.xml"), disk, settings));
  const ProblemList problems = settings.problems();
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[0].message, "scenario.gravity is of a scenario, and none is read here");
  EXPECT_EQ(problems[0].remedy, "omit it; info and modes take --gravity");
  EXPECT_EQ(problems[1].remedy, "omit it");
}

TEST(Settings, AreKeptWithAStudyAndRestoredWithIt) {
  const test::ProjectFolder folder;
  FileSource disk;
  Settings settings({"scenario.gravity=9.7 m/s^2", "frame.mass=8.9 t"});
  const StudyWork work = readStudyWork(folder.path("study.xml"), disk, settings).orThrow();
  settings.requireRight();
  EXPECT_EQ(work.inputs.vehicle.bodies[0].mass, 8900.0);
  EXPECT_EQ(work.inputs.scenarios[0].gravity, 9.7);
  EXPECT_EQ(work.texts.back().name, kSettingsName);
  EXPECT_EQ(work.texts.back().text, "frame.mass=8.9 t\nscenario.gravity=9.7 m/s^2\n");
  StudyRecord record;
  record.inputs = work.texts;
  const StudyWork again = restoreStudyWork(record);
  EXPECT_EQ(again.inputs.vehicle, work.inputs.vehicle);
  EXPECT_EQ(again.inputs.scenarios, work.inputs.scenarios);
  EXPECT_EQ(again.texts, work.texts);
  // Without any nothing more is kept than the files.
  EXPECT_EQ(readStudyWork(folder.path("study.xml"), disk).orThrow().texts.size() + 1, work.texts.size());
}

TEST(Settings, OfTheSpeedAreRefusedWhereAStudyOrSuiteGivesSpeeds) {
  const test::ProjectFolder folder;
  const std::string study = folder.put(
      "speeds.xml", test::withLine(test::kStudyLines, 4, R"(<vary parameter="speed" values="20 m/s, 30 m/s"/>)"));
  FileSource disk;
  Settings of_study({"speed=25 m/s"});
  static_cast<void>(readStudyWork(study, disk, of_study));
  EXPECT_EQ(of_study.problems()[0].message, "has no effect: the study gives the speeds itself");
  Settings of_suite({"speed=25 m/s"});
  static_cast<void>(readSuiteWork(folder.path("u.xml"), {}, disk, of_suite));
  EXPECT_EQ(of_suite.problems()[0].message, "has no effect: the suite gives the speeds itself");
}

TEST(Settings, OfASuiteReachEveryVehicleThatHasTheName) {
  const test::ProjectFolder folder;
  folder.put("other.xml", test::withLine(test::kVehicleLines, 2,
                                         R"(<element name="primary" stiffness_z="1 MN/m" damping_z="30 kN*s/m"/>)"));
  const std::string suite = folder.put("both.xml", R"(<suite name="u" format="1">
  <vehicle file="v.xml"/>
  <vehicle file="t.xml"/>
  <vehicle file="other.xml"/>
  <scenario file="s.xml"/>
  <form name="matrix"/>
</suite>
)");
  FileSource disk;
  Settings settings({"primary.stiffness_z=2 MN/m"});
  const SuiteWork work = readSuiteWork(suite, {}, disk, settings).orThrow();
  settings.requireRight();
  EXPECT_EQ(work.vehicles[0].elements[0].stiffness_z, 2e6);
  EXPECT_EQ(work.vehicles[1].elements[0].stiffness_z, 3040e3);  // v_1.primary
  EXPECT_EQ(work.vehicles[2].elements[0].stiffness_z, 2e6);
}

// What follows from a value is judged with it.
TEST(Settings, OfACheckedFileAreJudgedWithAllThatFollows) {
  const test::ProjectFolder folder;
  FileSource disk;
  Settings settings({"primary.stiffness_z=0 N/m"});
  const CheckedFile checked = checkFile(folder.path("v.xml"), disk, settings);
  EXPECT_TRUE(checked.problems.empty());
  ASSERT_EQ(settings.problems().size(), 1u);
  EXPECT_EQ(settings.problems()[0].message,
            "\"frame\" stands on nothing: no chain of springs leads from it down to a wheelset");
  EXPECT_EQ(checked.vehicle->elements[0].stiffness_z, 3040e3);  // as the file says it
}

}  // namespace
}  // namespace vehicle
