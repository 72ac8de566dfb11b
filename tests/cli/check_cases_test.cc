#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"
#include "tests/support/source_tree.h"

// Files that users wrote, and what the program says of them.
namespace vehicle::test {
namespace {

using Json = nlohmann::json;

std::string caseFile(const std::string& name) { return sourcePath("tests/cli/cases/") + name + ".xml"; }

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    lines.push_back(text.substr(at, end - at));
    at = end == std::string::npos ? text.size() : end + 1;
  }
  return lines;
}

/// The number of the line that "FILE:LINE: error: " or "FILE:LINE: warning: " names; -1 for another text.
int placeIn(const std::string& line, const std::string& file, const std::string& word = "error") {
  const std::string begin = file + ':';
  if (line.rfind(begin, 0) != 0) return -1;
  const std::size_t end = line.find(": " + word + ": ", begin.size());
  if (end == std::string::npos) return -1;
  return std::stoi(line.substr(begin.size(), end - begin.size()));
}

std::vector<int> placesIn(const std::string& text, const std::string& file, const std::string& word = "error") {
  std::vector<int> places;
  for (const std::string& line : linesOf(text)) places.push_back(placeIn(line, file, word));
  return places;
}

TEST(CheckCases, EachMistakeIsOneLineInItsPlace) {
  struct Case {
    const char* name;
    std::vector<int> lines;
    const char* says;
  };
  const std::vector<Case> cases = {
      {"preload-unbalanced", {6}, "leave a vertical force of -80000 N at rest"},
      {"no-place", {7}, "its static wheel load would be -370573 N"},
      {"unit-typo", {5}, "did you mean \"2 MN*m^-1\"?"},
      {"grad", {3}, "an angle is expected, e.g. \"1.2 mrad\"; did you mean \"200 deg\"?"},
      {"speed-typo", {2}, "did you mean \"20 km/h\"?"},
      {"eight-mistakes", {3, 5, 7, 8, 10, 11, 13, 18}, "\"ballast\" stands on nothing"},
  };
  for (const Case& each : cases) {
    const ProgramRun run = runVehicle({"check", caseFile(each.name)});
    EXPECT_EQ(run.status, 1) << each.name;
    EXPECT_EQ(placesIn(run.out, caseFile(each.name)), each.lines) << run.out;
    EXPECT_TRUE(has(run.out, each.says)) << run.out;
    EXPECT_EQ(run.err, "") << each.name;
  }
}

TEST(CheckCases, ABalanceWithinRoundingIsBalance) {
  const std::string file = caseFile("zero-load-spring");
  const ProgramRun run = runVehicle({"check", file});
  EXPECT_EQ(run.status, 0) << run.out;
  EXPECT_EQ(run.out, file + ": ok\n");
  EXPECT_TRUE(has(run.err, "[FAR_FROM_WHEELSET]")) << run.err;  // what is really wrong with it
}

TEST(CheckCases, AFileMayNameItsSchema) {
  EXPECT_EQ(runVehicle({"check", caseFile("names-its-schema")}).status, 0);
  const TestFolder folder;
  const std::string text = textOf(caseFile("names-its-schema"));
  const std::string model_first = "<?xml-model href=\"vehicle.xsd\" type=\"application/xml\"?>\n";
  const std::size_t end = text.find("?>") + 2;
  const std::vector<std::string> right = {
      text.substr(0, end) + "\n" + model_first + text.substr(end),
      text.substr(0, end) + "\n<!-- a comment before -->\n" + model_first + model_first + text.substr(end),
      text + model_first,
  };
  for (const std::string& each : right) {
    const ProgramRun run = runVehicle({"check", folder.file("v.xml", each)});
    EXPECT_EQ(run.status, 0) << each << run.out;
    // The second opinion: xmllint holds it valid by the shipped schema.
    const std::string command = "xmllint --noout --nonet --schema '" + sourcePath("models/vehicle.xsd") + "' '" +
                                folder.path("v.xml") + "' >/dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << each;
  }
  // Lines stay where they are behind what is ignored, and other instructions stay refused.
  std::string wrong = right[1];
  wrong.replace(wrong.find("45 t"), 4, "45 m");
  EXPECT_EQ(placesIn(runVehicle({"check", folder.file("v.xml", wrong)}).out, folder.path("v.xml")),
            (std::vector<int>{10}));
  for (const std::string other : {"<?xml-stylesheet href=\"a.css\"?>", "<?php echo 1; ?>", "<?xml-modelx?>"}) {
    const ProgramRun run = runVehicle({"check", folder.file("v.xml", text.substr(0, end) + other + text.substr(end))});
    EXPECT_EQ(run.status, 1) << other;
    EXPECT_TRUE(has(run.out, "processing instructions")) << run.out;
  }
  std::string inside = text;
  inside.insert(inside.find("<element"), model_first);
  EXPECT_EQ(runVehicle({"check", folder.file("v.xml", inside)}).status, 1);
}

TEST(RailCases, TheMeanOfBothRailsIsWhatWheelsetsMeet) {
  const auto railMinimum = [](const std::string& vehicle, const std::string& scenario, const std::string& column) {
    const ProgramRun run = runVehicle({"simulate", caseFile(vehicle), caseFile(scenario), "--format", "json"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(has(run.err, "note: " + caseFile(scenario) + ':')) << run.err;
    EXPECT_TRUE(has(run.err, "half of the height counts")) << run.err;
    const Json report = Json::parse(run.out);
    for (const Json& row : report["tables"]["columns"]["rows"]) {
      if (row["column"] == column) return row["min"].get<double>();
    }
    ADD_FAILURE() << "no column " << column;
    return 0.0;
  };
  // Samples fall on the middle of the dips: rounding of 8 mm.
  EXPECT_NEAR(railMinimum("vehicle", "left-and-right", "w1.rail_z"), -8e-3, 1e-17);
  EXPECT_NEAR(railMinimum("short-pitch-loco", "dip-left-rail", "w1.rail_z"), -4e-3, 1e-17);
}

TEST(RailCases, NotesAreNoWarningsAndQuietLeavesThemOut) {
  const ProgramRun run = runVehicle({"check", caseFile("dip-left-rail"), "--strict"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err,
            "note: " + caseFile("dip-left-rail") +
                ":5: rail=\"left\" or \"right\": planar forms take the mean of both rails, so half of the height "
                "counts\n");
  EXPECT_EQ(runVehicle({"check", caseFile("dip-left-rail"), "--quiet"}).err, "");
}

TEST(GeometryWarningCommand, IsGivenByCheckAndInfoWithItsPlace) {
  const std::string file = caseFile("forgotten-x");
  for (const std::string command : {"check", "info"}) {
    const ProgramRun run = runVehicle({command, file});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(placesIn(run.err, file, "warning"), (std::vector<int>{6, 10, 11})) << run.err;
    EXPECT_TRUE(has(run.err, "[FREE_PITCH]")) << run.err;
    EXPECT_EQ(runVehicle({command, file, "--strict"}).status, 4);
    const ProgramRun json = runVehicle({command, file, "--format", "json"});
    const Json rows = Json::parse(json.out)["tables"]["warnings"]["rows"];
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0]["code"], "FREE_PITCH");
    EXPECT_EQ(rows[0]["line"], 6);
    EXPECT_EQ(rows[0]["file"], file);
  }
}

// FREE_PITCH names the reason of the free mode: one line for both. What no place explains keeps its own.
TEST(GeometryWarningCommand, StandsBesideThoseOfTheRestPosition) {
  EXPECT_FALSE(has(runVehicle({"check", caseFile("forgotten-x")}).err, "FREE_MODE"));
  const std::string tips = caseFile("tips-over");
  for (const std::string command : {"check", "info"}) {
    const ProgramRun run = runVehicle({command, tips});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(placesIn(run.err, tips, "warning"), (std::vector<int>{6})) << run.err;
    EXPECT_TRUE(has(run.err, "[CANNOT_STAND]")) << run.err;
  }
}

TEST(GeometryWarningCommand, NamesAxlesAtOnePlaceAndVehiclesInEachOther) {
  const TestFolder folder;
  std::string text = textOf(caseFile("vehicle"));
  const std::string second = R"(<wheelset name="w2" x="-1.5 m"/>)";
  text.replace(text.find(second), second.size(), R"(<wheelset name="w2" x="1.5 m"/>)");
  const ProgramRun same = runVehicle({"check", folder.file("v.xml", text)});
  EXPECT_EQ(same.status, 0) << same.out;
  EXPECT_TRUE(has(same.err, folder.path("v.xml") + ":8: warning: w2: stands where \"w1\" stands")) << same.err;
  folder.file("coach.xml", textOf(caseFile("vehicle")));
  const std::string train = folder.file(
      "t.xml",
      "<train name=\"t\" format=\"1\">\n  <vehicle file=\"coach.xml\" count=\"3\" spacing=\"8 m\"/>\n</train>\n");
  const ProgramRun overlap = runVehicle({"check", train});
  EXPECT_EQ(overlap.status, 0) << overlap.out;
  EXPECT_TRUE(has(overlap.err, train + ":2: warning: v_2: stands 2.45 m deep in \"v_1\"")) << overlap.err;
}

// Of the shipped models only the two Pioneer cars are warned of, and that is true: their secondaries come down by more
// than half a metre (208 kN on 0.4 MN/m, 215.8 kN on 0.35 MN/m).
TEST(GeometryWarningCommand, IsNeverGivenForTheShippedModels) {
  // Folder by folder: a rig for one vehicle does not fit a train.
  for (const std::string folder : {"vehicles", "trains", "scenarios", "suites", "studies"}) {
    std::vector<std::string> arguments = {"check"};
    for (const auto& entry : std::filesystem::directory_iterator(model(folder))) {
      arguments.push_back(entry.path().string());
    }
    const ProgramRun run = runVehicle(arguments);
    EXPECT_EQ(run.status, 0) << run.out;
    int warnings = 0;
    for (const std::string& line : linesOf(run.err)) {
      if (!has(line, "warning:")) continue;
      ++warnings;
      EXPECT_TRUE(has(line, "/pioneer-") && has(line, "secondary") && has(line, "[REST_DEFLECTION]")) << line;
    }
    EXPECT_EQ(warnings, folder == std::string("vehicles") ? 4 : 0) << run.err;
  }
}

TEST(HertzNote, StandsWhereAVehicleHasSuchAContact) {
  const TestFolder folder;
  std::string text = textOf(caseFile("vehicle"));
  const std::string first = R"(<wheelset name="w1" x="1.5 m"/>)";
  text.replace(text.find(first), first.size(),
               R"(<wheelset name="w1" x="1.5 m" mass="1 t" hertz_constant="90 GN/m^1.5"/>)");
  const std::string file = folder.file("v.xml", text);
  for (const std::string command : {"check", "info"}) {
    EXPECT_EQ(runVehicle({command, file}).err,
              "note: " + file + ":7: hertz_constant: the contact is linearised at the static load and cannot open\n");
  }
}

TEST(InfoFigures, AreThoseThatAnEngineerChecksFirst) {
  const ProgramRun run = runVehicle({"info", caseFile("short-pitch-loco"), "--format", "json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json report = Json::parse(run.out);
  // 75 t under 9.81 m/s^2; equal loads have no halves.
  EXPECT_NEAR(report["facts"]["total weight"]["value"].get<double>(), 735.75e3, 1e-9);
  EXPECT_FALSE(report["facts"].contains("load of the front half"));
  EXPECT_FALSE(report["tables"]["wheelsets"]["rows"][0].contains("from the mean"));
  // Half the carbody on 2.7 MN/m; rounding of a solve.
  const Json springs = report["tables"]["suspensions"]["rows"];
  EXPECT_NEAR(springs[0]["rest deflection"].get<double>(), 28.5e3 * 9.81 / 2.7e6, 1e-12);
  const Json motions = report["tables"]["carbody"]["rows"];
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_EQ(motions[0]["motion"], "carbody bounce");
  EXPECT_EQ(motions[1]["motion"], "carbody pitch");
  // The modes' own numbers.
  const Json modes = Json::parse(
      runVehicle({"modes", caseFile("short-pitch-loco"), "--format", "json"}).out)["tables"]["modes"]["rows"];
  for (const Json& motion : motions) {
    bool found = false;
    for (const Json& mode : modes) {
      found = found || (mode["name"] == motion["motion"] && mode["frequency"] == motion["frequency"]);
    }
    EXPECT_TRUE(found) << motion;
  }
}

TEST(InfoFigures, LoadsThatDifferAreShownAgainstTheirMean) {
  const TestFolder folder;
  std::string text = textOf(caseFile("short-pitch-loco"));
  const std::string carbody = "<body name=\"carbody\" ";
  text.replace(text.find(carbody), carbody.size(), carbody + "x=\"0.37 m\" ");
  const ProgramRun run = runVehicle({"info", folder.file("v.xml", text), "--format", "json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json report = Json::parse(run.out);
  // The lever rule: the front carries (3.7 + 0.37) / 7.4 of the carbody and one bogie.
  const double front = (57e3 * (3.7 + 0.37) / 7.4 + 9e3) * 9.81;
  EXPECT_NEAR(report["facts"]["load of the front half"]["value"].get<double>(), front, 1e-6);
  EXPECT_NEAR(report["facts"]["load of the rear half"]["value"].get<double>(), 735.75e3 - front, 1e-6);
  EXPECT_NEAR(report["tables"]["wheelsets"]["rows"][0]["from the mean"].get<double>(),
              1e2 * (front / 2.0 / (735.75e3 / 4.0) - 1.0), 1e-9);
}

TEST(InfoFigures, UnusedValuesAreOneLineForPeopleAndRowsForPrograms) {
  const TestFolder folder;
  std::string text = textOf(caseFile("vehicle"));
  for (const std::string body : {"carbody", "b1", "b2"}) {
    const std::string begin = "<body name=\"" + body + "\" ";
    text.replace(text.find(begin), begin.size(), begin + "roll_inertia=\"50 t*m^2\" ");
  }
  const std::string begin = "<body name=\"carbody\" ";
  text.replace(text.find(begin), begin.size(), begin + "yaw_inertia=\"900 t*m^2\" ");
  const std::string file = folder.file("v.xml", text);
  const std::string out = runVehicle({"info", file}).out;
  EXPECT_TRUE(has(out, "not used by the planar forms: yaw_inertia of carbody, roll_inertia of 3 parts\n")) << out;
  const Json report = Json::parse(runVehicle({"info", file, "--format", "json"}).out);
  EXPECT_EQ(report["tables"]["not used by the planar forms"]["rows"].size(), 4u);
}

// A negative zero is a zero: rig-driven wheelsets at rest, empty phases, sums that cancel.
TEST(Output, HoldsNoNegativeZero) {
  const TestFolder folder;
  const std::string scenario =
      folder.file("rig.xml",
                  "<scenario name=\"rig\" format=\"1\">\n  <run duration=\"0.1 s\" output_step=\"5 ms\"/>\n  "
                  "<rig><input wheelset=\"w1\">"
                  "<sine amplitude=\"-1 mm\" frequency=\"5 Hz\" phase=\"-0 rad\"/></input></rig>\n</scenario>\n");
  static const std::regex kNegativeZero("(^|[^0-9A-Za-z.])-0(\\.0*)?($|[^0-9.eE])");
  for (const std::string format : {"table", "csv", "json"}) {
    const ProgramRun run =
        runVehicle({"simulate", caseFile("vehicle"), scenario, "--format", format, "--output", folder.path("run.csv")});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_FALSE(std::regex_search(run.out, kNegativeZero)) << run.out;
  }
  EXPECT_FALSE(std::regex_search(textOf(folder.path("run.csv")), kNegativeZero));
}

}  // namespace
}  // namespace vehicle::test
