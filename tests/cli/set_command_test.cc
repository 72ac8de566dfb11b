// --set: numbers of the command line in place of those of the files.
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "libvehicle/storage/hdf5.h"
#include "libvehicle/storage/study_database.h"
#include "tests/cli/studies.h"
#include "tests/support/source_tree.h"

namespace vehicle::test {
namespace {

using nlohmann::json;

/// v.xml and s.xml, and the small study of them.
struct Files {
  TestFolder folder;
  std::string vehicle = folder.file("v.xml", smallVehicle());
  std::string scenario = folder.file("s.xml", smallScenario(R"(speed="20 m/s" duration="1 s" output_step="5 ms")"));
  std::string study = smallStudyIn(folder, smallStudy());
};

const std::string kSetting = "spring.stiffness_z=0.8 MN/m";

TEST(SetCommand, EveryCommandTakesItAndSaysSoInItsResult) {
  const Files files;
  const std::string database = files.folder.path("study.sqlite");
  const std::vector<std::vector<std::string>> lines = {
      {"info", files.vehicle},
      {"modes", files.vehicle},
      {"simulate", files.vehicle, files.scenario},
      {"simulate", files.vehicle, files.scenario, "--speed", "20 m/s, 30 m/s"},
      {"validate", files.vehicle, files.scenario},
      {"profile", files.vehicle, files.scenario, "--threads", "1"},
      {"study", files.study, "--output", database},
  };
  for (std::vector<std::string> line : lines) {
    SCOPED_TRACE(line.front());
    line.insert(line.end(), {"--set", kSetting, "--format", "json"});
    const ProgramRun run = runVehicle(line);
    ASSERT_TRUE(run.status == 0 || run.status == 4) << run.err;  // a pair of runs may lie outside on a loaded machine
    EXPECT_EQ(json::parse(run.out).at("facts").at("set spring.stiffness_z").at("value"), "0.8 MN/m") << run.out;
  }
  EXPECT_EQ(runVehicle({"check", files.vehicle, files.scenario, "--set", kSetting}).status, 0);
}

TEST(SetCommand, ItsHelpShowsAValueWithUnit) {
  for (const char* command : {"check", "info", "modes", "simulate", "validate", "profile", "study"}) {
    // Lines of help break at spaces.
    std::istringstream words(runVehicle({"help", command}).out);
    std::string page;
    for (std::string word; words >> word;) page += word + ' ';
    EXPECT_TRUE(has(page, "--set NAME=VALUE a number in place of the file's, e.g. \"secondary.stiffness_z=600 kN/m\""))
        << command << '\n'
        << page;
  }
}

// The bits of a run are those of a file that has been edited, and the result keeps what was set beside the files.
TEST(SetCommand, ARunIsThatOfTheEditedFileAndItsRecordHoldsTheSetting) {
  const Files files;
  const std::string edited =
      files.folder.file("edited.xml", with(smallVehicle(), "stiffness_z=\"1 MN/m\"", "stiffness_z=\"0.8 MN/m\""));
  const std::string of_set = files.folder.path("set.h5");
  const std::string of_edited = files.folder.path("edited.h5");
  ASSERT_EQ(runVehicle({"simulate", files.vehicle, files.scenario, "--set", kSetting, "--output", of_set}).status, 0);
  ASSERT_EQ(runVehicle({"simulate", edited, files.scenario, "--output", of_edited}).status, 0);
  const RunRecord set = readHdf5(of_set).orThrow();
  const RunRecord by_hand = readHdf5(of_edited).orThrow();
  ASSERT_EQ(set.history.samples(), by_hand.history.samples());
  for (std::size_t column = 0; column < set.history.columns().size(); ++column) {
    EXPECT_EQ(set.history.column(column), by_hand.history.column(column));
  }
  std::string recorded;
  for (const auto& [name, value] : set.attributes) recorded += name == "set spring.stiffness_z" ? value : "";
  EXPECT_EQ(recorded, "0.8 MN/m");
  EXPECT_EQ(set.inputs[0].text, smallVehicle());
}

TEST(SetCommand, AllMistakesArePrintedAtOnceAsOfTheCommandLine) {
  const Files files;
  const std::string in_place = "vehicle: --set ";
  for (const std::vector<std::string>& line : {std::vector<std::string>{"simulate", files.vehicle, files.scenario},
                                               {"validate", files.vehicle, files.scenario},
                                               {"profile", files.vehicle, files.scenario},
                                               {"check", files.vehicle, files.scenario},
                                               {"study", files.study, "--output", files.folder.path("no.sqlite")},
                                               {"info", files.vehicle},
                                               {"modes", files.vehicle}}) {
    SCOPED_TRACE(line.front());
    std::vector<std::string> words = line;
    words.insert(words.end(), {"--set", "sprin.stiffness_z=1 kN/m", "--set", "carbody.mass=9"});
    const ProgramRun run = runVehicle(words);
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err, in_place +
                           "\"sprin.stiffness_z=1 kN/m\": parameter \"sprin.stiffness_z\" is unknown; did you mean "
                           "\"spring.stiffness_z\"?\n" +
                           in_place + "\"carbody.mass=9\": \"9\" has no unit; a mass is expected, e.g. \"57 t\"\n");
  }
}

TEST(SetCommand, TheSpeedIsGivenOnce) {
  const Files files;
  const ProgramRun run =
      runVehicle({"simulate", files.vehicle, files.scenario, "--speed", "20 m/s", "--set", "speed=30 m/s"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "vehicle: --speed and --set speed both give the running speed; give one of them\n");
}

TEST(SetCommand, AStudyGoesOnWithTheSameSettingsOnly) {
  const Files files;
  const std::string database = files.folder.path("study.sqlite");
  const std::vector<std::string> line = {"study", files.study, "--output", database, "--set", kSetting};
  ASSERT_EQ(runVehicle(line).status, 0);
  const StudyRecord record = StudyDatabase::read(database).record();
  EXPECT_EQ(record.inputs.back().name, "--set");
  EXPECT_EQ(record.inputs.back().text, kSetting + "\n");
  std::vector<std::string> again = line;
  again.emplace_back("--resume");
  EXPECT_EQ(runVehicle(again).status, 0);
  again[5] = "spring.stiffness_z=0.9 MN/m";
  const ProgramRun other = runVehicle(again);
  EXPECT_EQ(other.status, 1);
  EXPECT_TRUE(has(other.err, "--set:1: error: changed since " + database +
                                 " was begun: the line was \"spring.stiffness_z=0.8 MN/m\" and is now "
                                 "\"spring.stiffness_z=0.9 MN/m\"\n"))
      << other.err;
  const ProgramRun none = runVehicle({"study", files.study, "--output", database, "--resume"});
  EXPECT_EQ(none.status, 1);
  EXPECT_TRUE(has(none.err, "--set: error: was a part of the study when")) << none.err;
  const ProgramRun shown = runVehicle({"study", "show", database, "--format", "json"});
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_EQ(json::parse(shown.out).at("facts").at("set spring.stiffness_z").at("value"), "0.8 MN/m");
  const ProgramRun useless = runVehicle({"study", "show", database, "--set", kSetting});
  EXPECT_EQ(useless.status, 2);
  EXPECT_TRUE(has(useless.err, "--set has no effect: study show evaluates nothing")) << useless.err;
}

// The page on comparing designs shows the beginning of this page of the program.
TEST(SetCommand, IsShownByItsPageAsItPrints) {
  const Columns width("110");
  const ProgramRun run =
      runVehicle({"modes", model("vehicles/manchester-coach.xml"), "--set", "secondary.stiffness_z=600 kN/m"});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string beginning = run.out.substr(0, run.out.find("\n     2 ") + 1);
  EXPECT_EQ(linesOf(beginning).size(), 8u) << run.out;
  EXPECT_TRUE(has(textOf(sourcePath("docs/how-to/compare-designs.md")), beginning)) << beginning;
}

// The base is the vehicle as it has been set: its row is that of a study whose vehicle file says so.
TEST(SetCommand, AStudyIsThatOfTheEditedVehicle) {
  const Files files;
  ASSERT_EQ(runVehicle({"study", files.study, "--output", files.folder.path("set.sqlite"), "--set", kSetting,
                        "--export", files.folder.path("set.csv")})
                .status,
            0);
  files.folder.file("v.xml", with(smallVehicle(), "stiffness_z=\"1 MN/m\"", "stiffness_z=\"0.8 MN/m\""));
  ASSERT_EQ(runVehicle({"study", files.study, "--output", files.folder.path("edited.sqlite"), "--export",
                        files.folder.path("edited.csv")})
                .status,
            0);
  const std::string table = textOf(files.folder.path("set.csv"));
  EXPECT_EQ(linesOf(table).size(), 4u) << table;
  EXPECT_EQ(table, textOf(files.folder.path("edited.csv")));
}

}  // namespace
}  // namespace vehicle::test
