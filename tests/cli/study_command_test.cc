// What is wrong with a study, its command or its files, as the user is told.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/studies.h"

namespace vehicle::test {
namespace {

struct Refusal {
  std::vector<std::string> arguments;
  int status = 2;
  std::string message;  // all of stderr
};

void expectRefusals(const std::vector<Refusal>& refusals) {
  for (const Refusal& each : refusals) {
    const ProgramRun run = runVehicle(each.arguments);
    EXPECT_EQ(run.status, each.status) << each.message;
    EXPECT_EQ(run.out, "") << each.message;
    EXPECT_EQ(run.err, each.message);
  }
}

TEST(StudyCommand, WhatTheCommandLineLacksOrHasTooMuchIsTold) {
  const TestFolder folder;
  const std::string study = smallStudyIn(folder);
  const std::string there = folder.file("there.sqlite", "mine");
  const std::string to = folder.path("to.sqlite");
  expectRefusals({
      {{"study"}, 2, "vehicle study: STUDY|show is missing; see vehicle study --help\n"},
      {{"study", study},
       2,
       "vehicle: study: --output is missing, e.g. --output study.sqlite: every design is kept there\n"},
      {{"study", study, "more.xml", "--output", to},
       2,
       "vehicle: study: \"more.xml\" is one file too many; only `study show` takes a second\n"},
      {{"study", study, "--output", there},
       2,
       "vehicle: --output: " + there +
           " exists already; go on with it by --resume, begin it anew by --overwrite, or "
           "name another file\n"},
      {{"study", study, "--output", folder.root().string()},
       2,
       "vehicle: --output " + folder.root().string() + ": extension \"\" is unknown; name it .sqlite (SQLite)\n"},
      {{"study", study, "--output", to, "--jobs", "0"},
       2,
       "vehicle study: --jobs: \"0\" must be a whole number 1..1024; see vehicle study --help\n"},
      {{"study", study, "--outptu", to},
       2,
       "vehicle study: option \"--outptu\" is unknown; did you mean \"--output\"?\n"},
      {{"study", "show"}, 2, "vehicle: study show: DATABASE is missing\n"},
      {{"study", "show", there, "--output", to},
       2,
       "vehicle: --output has no effect: study show evaluates nothing; omit it\n"},
  });
  EXPECT_EQ(textOf(there), "mine");
  EXPECT_FALSE(std::filesystem::exists(to));
}

TEST(StudyCommand, ADatabaseThatCannotBeShownIsNamedWithTheReason) {
  const TestFolder folder;
  const std::string study = smallStudyIn(folder);
  const std::string newer = folder.path("newer.sqlite");
  ASSERT_EQ(runVehicle({"study", study, "--output", newer}).status, 0);
  {
    // The user version is the big-endian number at byte 60 of an SQLite file (its format, section 1.3).
    std::fstream file(newer, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(63);
    file.put(9);
  }
  const std::string none = folder.path("none.sqlite");
  const std::string text = folder.file("text.sqlite", "no database");
  const std::string no_sqlite =
      ": error: holds no study: it is no SQLite file; name a database that `vehicle study --output` wrote\n";
  const std::string of_format_9 =
      ": error: holds a study in format 9, this program reads formats 1 to 2; name a database that this program's `vehicle "
      "study --output` wrote\n";
  const std::string where = folder.root().string();
  expectRefusals({
      {{"study", "show", study}, 1, study + no_sqlite},
      {{"study", "show", none},
       1,
       none + ": error: cannot be read: No such file or directory; check the name of the "
              "file\n"},
      {{"study", "show", where}, 1, where + ": error: is a folder; name a file in it\n"},
      {{"study", "show", newer}, 1, newer + of_format_9},
      {{"study", study, "--output", newer, "--resume"}, 1, newer + of_format_9},
      {{"study", study, "--output", text, "--resume"}, 1, text + no_sqlite},
  });
}

TEST(StudyCommand, ADamagedDatabaseIsAWrongInput) {
  const TestFolder folder;
  const std::string study = smallStudyIn(folder);
  const std::string database = folder.path("study.sqlite");
  ASSERT_EQ(runVehicle({"study", study, "--output", database}).status, 0);
  const std::string whole = textOf(database);
  std::string cut = whole.substr(0, whole.size() / 2);
  std::string scribbled = whole;
  // Behind the header of the first page every byte of the schema.
  std::fill(scribbled.begin() + 100, scribbled.end(), 'x');
  for (const std::string& damaged : {cut, scribbled}) {
    folder.file("study.sqlite", damaged);
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"study", "show", database}, {"study", study, "--output", database, "--resume"}}) {
      const ProgramRun run = runVehicle(words);
      EXPECT_EQ(run.status, 1) << run.err;
      EXPECT_TRUE(run.err.starts_with(database + ": error: ")) << run.err;
      EXPECT_EQ(linesOf(run.err).size(), 1u) << run.err;
    }
    EXPECT_TRUE(textOf(database) == damaged);
  }
}

TEST(StudyCommand, ADatabaseOfAnotherStudyIsSaidInOneLineWithItsTruePath) {
  const TestFolder folder;
  const std::string study = smallStudyIn(folder);
  const std::string database = folder.path("study.sqlite");
  ASSERT_EQ(runVehicle({"study", study, "--output", database}).status, 0);
  folder.file("sub/v.xml", with(smallVehicle(), "10 t", "11 t"));
  folder.file("sub/s.xml", textOf(folder.path("s.xml")));
  const std::string other = folder.file("sub/study.xml", with(smallStudy(), "name=\"springs\"", "name=\"dampers\""));
  const std::string same = folder.file("sub/same.xml", smallStudy());
  expectRefusals({
      {{"study", other, "--output", database, "--resume"},
       1,
       database + ": error: holds the study \"springs\", and " + other +
           " is the study \"dampers\"; name the database " + "of this study, or another file for a new one\n"},
      {{"study", same, "--output", database, "--resume"},
       1,
       folder.path("sub/v.xml") + ":3: error: changed since " + database + " was begun: the line was \"  <body " +
           "name=\"carbody\" mass=\"10 t\" motion=\"z\"/>\" and is now \"  <body name=\"carbody\" mass=\"11 t\" " +
           "motion=\"z\"/>\"\n" + database +
           ": error: holds designs of the study as it was; bring the files back, or " + "write to a new file\n"},
  });
}

TEST(StudyCommand, EveryNameThatIsUnknownIsToldWithTheNearestOne) {
  const TestFolder folder;
  std::string text = with(smallStudy(), "spring.stiffness_z", "sprung.stiffness_z");
  for (int time = 0; time < 2; ++time) text = with(text, "carbody.az.rms", "carbodi.az.rms");  // metric and objective
  const std::string study = smallStudyIn(folder, text);
  expectRefusals({{{"study", study, "--output", folder.path("to.sqlite")}, 1,
                   study + ":5: error: <study><design><set>: parameter \"sprung.stiffness_z\" is unknown; did you mean "
                           "\"spring.stiffness_z\"?\n" +
                       study + ":7: error: <study><metric>: name=\"carbodi.az.rms\" asks for a column that the vehicle "
                               "\"small\" has not; did you mean \"carbody.az\"?\n"}});
}

TEST(StudyCommand, AFileThatIsMissingIsToldOnce) {
  const TestFolder folder;
  const std::string none = folder.path("none.xml");
  expectRefusals({{{"study", none, "--output", folder.path("to.sqlite")}, 1,
                   none + ": error: cannot be read: No such file or directory; check the name of the file\n"}});
}

TEST(StudyCommand, AChangedStudyIsRefusedWithTheChangedLines) {
  const TestFolder folder;
  const std::string study = smallStudyIn(folder);
  const std::string database = folder.path("study.sqlite");
  ASSERT_EQ(runVehicle({"study", study, "--output", database}).status, 0);
  const std::string before = textOf(database);
  folder.file("study.xml", with(smallStudy(), "0.5 MN/m", "0.6 MN/m"));
  folder.file("v.xml", with(smallVehicle(), "10 t", "11 t"));
  const std::string design =
      R"("  <design name="soft"><set parameter="spring.stiffness_z" value="0.5 MN/m"/></design>")";
  const std::string body = R"("  <body name="carbody" mass="10 t" motion="z"/>")";
  const std::string since = ": error: changed since " + database + " was begun: the line was ";
  expectRefusals({{{"study", study, "--output", database, "--resume"}, 1,
                   study + ":5" + since + design + " and is now " + with(design, "0.5", "0.6") + "\n" +
                       folder.path("v.xml") + ":3" + since + body + " and is now " + with(body, "10", "11") + "\n" +
                       database + ": error: holds designs of the study as it was; bring the files back, or write " +
                       "to a new file\n"}});
  EXPECT_EQ(textOf(database), before);
}

TEST(StudyCommand, WhatCannotBeWrittenIsToldBeforeAnyDesign) {
  const TestFolder folder;
  const std::string study = smallStudyIn(folder);
  const std::string to = folder.path("to.sqlite");
  const std::string rule = "; its folder must exist and be writable\n";
  expectRefusals({
      {{"study", study, "--output", "/no-such-folder/to.sqlite"}, 3,
       "vehicle: /no-such-folder/to.sqlite: cannot be written: No such file or directory" + rule},
      {{"study", study, "--output", study + "/to.sqlite"}, 3,
       "vehicle: " + study + "/to.sqlite: cannot be written: Not a directory" + rule},
      {{"study", study, "--output", "/proc/to.sqlite"}, 3,
       "vehicle: /proc/to.sqlite: cannot be written: No such file or directory" + rule},
      {{"study", study, "--output", to, "--export", "/no-such-folder/to.csv"}, 3,
       "vehicle: /no-such-folder/to.csv: cannot be written: No such file or directory" + rule},
      {{"study", study, "--output", to, "--write-best", study + "/best"}, 3,
       "vehicle: " + study + "/best: the folder cannot be made: Not a directory\n"},
  });
  EXPECT_FALSE(std::filesystem::exists(to));
}

// An unknown mode costs its own values only; it is printed where the metric stands, in every output, and counts with
// --strict.
TEST(StudyCommand, AModeThatTheVehicleLacksIsAWarningAndItsValuesAreEmpty) {
  const TestFolder folder;
  const std::string study = smallStudyIn(
      folder, with(smallStudy(), "<objective", "<metric name=\"mode.carbody bounse.damping\"/>\n  <objective"));
  const std::string database = folder.path("study.sqlite");
  const std::string tail =
      ":9: warning: mode.carbody bounse.damping: mode \"carbody bounse\" is unknown in the vehicle as its file says "
      "it: "
      "the metric has no value in any design; did you mean \"carbody bounce\"? [UNKNOWN_MODE]\n";
  const ProgramRun run = runVehicle({"study", study, "--output", database, "--quiet"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, study + tail);
  EXPECT_TRUE(has(run.out, "\nfailed               0\n")) << run.out;
  EXPECT_TRUE(has(tableCalled("missing values", run.out),
                  "        3  mode.carbody bounse.damping  mode \"carbody bounse\" is unknown; did you mean"))
      << run.out;
  const ProgramRun shown = runVehicle({"study", "show", database, "--format", "json", "--strict"});
  EXPECT_EQ(shown.status, 4);
  EXPECT_EQ(shown.err, "study.xml" + tail);  // the file that the database keeps
  const nlohmann::json answer = nlohmann::json::parse(shown.out);
  EXPECT_EQ(answer["tables"]["warnings"]["rows"][0]["code"], "UNKNOWN_MODE");
  EXPECT_EQ(answer["tables"]["warnings"]["rows"][0]["line"], 9);
}

TEST(StudyCommand, DoubtfulSaltelliPlansWarnBeforeAndAfter) {
  const TestFolder folder;
  const std::string study = folder.file(
      "study.xml", paperStudy(R"(<vary parameter="carbody.mass" from="50 t" to="60 t"/>
  <plan kind="saltelli" size="20"/>)",
                              R"(<metric name="carbody.az.rms"/> <metric name="static.secondary_front.load"/>
  <metric name="primary_1.force.mean"/>)"));
  const ProgramRun run = runVehicle({"study", study, "--output", folder.path("study.sqlite")});
  EXPECT_EQ(run.status, 0) << run.err;
  const std::vector<std::string> lines = linesOf(run.err);
  ASSERT_EQ(lines.size(), 2u) << run.err;
  EXPECT_TRUE(has(lines[0], study + ":5: warning: <study><plan>: size=\"20\" is no power of two")) << run.err;
  EXPECT_TRUE(has(lines[0], "take 16 or 32 [SAMPLE_SIZE]")) << run.err;
  EXPECT_TRUE(
      has(lines[1], "warning: primary_1.force.mean: no sensitivity index can be given: it is 0 in every design"))
      << run.err;
  EXPECT_EQ(runVehicle({"study", "show", folder.path("study.sqlite"), "--strict"}).status, 4);
}

TEST(StudyCommand, SecondOrderBelongsToSaltelli) {
  const TestFolder folder;
  const std::string study =
      folder.file("study.xml", paperStudy(R"(<vary parameter="carbody.mass" from="50 t" to="60 t"/>
  <plan kind="sobol" size="16" second_order="yes"/>)"));
  expectRefusals({{{"study", study, "--output", folder.path("to.sqlite")},
                   1,
                   study + ":5: error: <study><plan>: has second_order with another kind than saltelli; write "
                           "kind=\"saltelli\", or remove second_order\n"}});
}

// A wagon whose centre of gravity is too high for its springs tips over: its motion grows until it leaves the numbers.
TEST(StudyCommand, AStudyThatFailsInEveryDesignSaysWhyAndEndsWithThree) {
  const TestFolder folder;
  const std::string study = folder.file("study.xml", R"(<study name="tips" format="1">
  <vehicle file="v.xml"/>
  <scenario file="s.xml"/>
  <design name="heavy"><set parameter="carbody.mass" value="60 t"/></design>
  <metric name="carbody.az.rms"/>
</study>
)");
  folder.file("v.xml", R"(<vehicle name="tips-over" format="1">
  <element name="leaf" stiffness_z="100 kN/m" damping_z="1 kN*s/m"/>
  <body name="carbody" mass="10 t" z="3 m" pitch_inertia="5 t*m^2" motion="z pitch"/>
  <wheelset name="w1" x="0.5 m" z="0.45 m"/> <wheelset name="w2" x="-0.5 m" z="0.45 m"/>
  <suspension name="s1" element="leaf" upper="carbody" lower="w1" x="0.5 m" z="0.5 m"/>
  <suspension name="s2" element="leaf" upper="carbody" lower="w2" x="-0.5 m" z="0.5 m"/>
</vehicle>
)");
  folder.file("s.xml", smallScenario(R"(speed="20 m/s" duration="300 s" output_step="50 ms")"));
  const ProgramRun run = runVehicle({"study", study, "--output", folder.path("study.sqlite"), "--quiet"});
  EXPECT_EQ(run.status, 3);
  EXPECT_TRUE(has(run.err, "vehicle: every design of the study failed: ")) << run.err;
  const std::vector<std::string> lines = linesOf(tableCalled("failed designs", run.out));
  ASSERT_EQ(lines.size(), 4u) << run.out;
  EXPECT_EQ(lines[1], "  design  why");
  EXPECT_TRUE(lines[2].starts_with("  base    ") && has(lines[2], "not finite at t = ")) << lines[2];
  EXPECT_TRUE(lines[3].starts_with("  heavy   ") && has(lines[3], "not finite at t = ")) << lines[3];
  EXPECT_TRUE(has(run.out, "\nfailed         2\n")) << run.out;
}

}  // namespace
}  // namespace vehicle::test
