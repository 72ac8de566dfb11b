// Tables for people show the units of the railway, csv and json SI.
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/output_table.h"

namespace vehicle::test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

Words plus(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

const std::string kCoach = model("vehicles/manchester-coach.xml");
const std::string kPaper = model("vehicles/al-oraiqat-2017.xml");
const std::string kHertz = model("vehicles/manchester-coach-hertz.xml");
const std::string kTrain = model("trains/three-coaches.xml");
const std::string kRail = model("scenarios/paper-20mps.xml");

/// A column of a table: in json in SI, for people in `shown`.
struct Column {
  Words words;
  const char* table;
  const char* column;
  const char* si;
  const char* shown;
};

std::vector<Column> columns(const OutputFiles& files) {
  const std::string suite = files.file("suite.xml",
                                       "<suite name=\"small\" format=\"1\"><vehicle file=\"v.xml\"/>"
                                       "<scenario file=\"short.xml\"/></suite>");
  return {
      {{"validate", suite}, "cases", "speed", "m/s", "km/h"},
      {{"info", kCoach}, "bodies", "mass", "kg", "t"},
      {{"info", kCoach}, "bodies", "pitch inertia", "kg*m^2", "t*m^2"},
      {{"info", kCoach}, "bodies", "rest z", "m", "mm"},
      {{"info", kCoach}, "bodies", "x", "m", "m"},
      {{"info", kHertz}, "wheelsets", "mass", "kg", "t"},
      {{"info", kHertz}, "wheelsets", "contact stiffness", "N/m", "MN/m"},
      {{"info", kCoach}, "wheelsets", "static load", "N", "kN"},
      {{"info", kCoach}, "suspensions", "stiffness", "N/m", "kN/m"},
      {{"info", kCoach}, "suspensions", "damping", "N*s/m", "kN*s/m"},
      {{"info", kCoach}, "suspensions", "static load", "N", "kN"},
      {{"info", kCoach}, "suspensions", "rest deflection", "m", "mm"},
      {{"info", kTrain}, "vehicles", "mass", "kg", "t"},
      {{"info", kTrain}, "vehicles", "static load", "N", "kN"},
      {{"modes", kCoach}, "modes", "frequency", "Hz", "Hz"},
  };
}

TEST(ShownUnits, OfColumnsAreForPeopleInTablesAndSiInJson) {
  const OutputFiles files;
  for (const Column& each : columns(files)) {
    SCOPED_TRACE(each.words[0] + " " + each.words[1] + ": " + each.column);
    const json read = json::parse(runVehicle(plus(each.words, {"--format", "json"})).out);
    ASSERT_TRUE(read["tables"].contains(each.table));
    EXPECT_EQ(read["tables"][each.table]["units"][each.column], each.si);
    const std::string text = "\n" + runVehicle(each.words).out;
    const std::string table = tableCalled(std::string(each.table) + "\n", text);
    EXPECT_TRUE(has(table, std::string(each.column) + " [" + each.shown + "]")) << table;
  }
}

/// A fact of a command.
struct Fact {
  Words words;
  const char* name;
  const char* si;
  const char* shown;
  double factor;  // from SI
};

TEST(ShownUnits, OfFactsAreForPeopleInTablesAndSiInJson) {
  const OutputFiles files;
  const std::vector<Fact> facts = {
      {{"info", kCoach}, "total mass", "kg", "t", 1e-3},
      {{"info", kCoach}, "total weight", "N", "kN", 1e-3},
      {{"info", kHertz}, "unsprung mass", "kg", "t", 1e-3},
      {{"simulate", kPaper, kRail}, "speed", "m/s", "km/h", 3.6},
      {{"validate", kPaper, files.path("short.xml"), "--serial"}, "speed", "m/s", "km/h", 3.6},
      {{"profile", kPaper, files.path("short.xml"), "--threads", "1"}, "speed", "m/s", "km/h", 3.6},
  };
  for (const Fact& each : facts) {
    SCOPED_TRACE(each.words[0] + ": " + each.name);
    const json read = json::parse(runVehicle(plus(each.words, {"--format", "json"})).out);
    ASSERT_TRUE(read["facts"].contains(each.name));
    EXPECT_EQ(read["facts"][each.name]["unit"], each.si);
    std::string line;
    for (const std::string& candidate : linesOf(runVehicle(each.words).out)) {
      if (candidate.starts_with(std::string(each.name) + "  ")) line = candidate;
    }
    ASSERT_TRUE(line.ends_with(std::string(" ") + each.shown)) << line;
    const double shown = std::stod(line.substr(std::string(each.name).size()));
    // Five digits are printed.
    const double expected = each.factor * read["facts"][each.name]["value"].get<double>();
    EXPECT_NEAR(shown, expected, 5e-5 * expected);
  }
}

// A history has a unit a row: the pitch of the carbody is milliradians, forces are kilonewtons.
TEST(ShownUnits, OfAHistoryFollowTheSizeOfEachColumn) {
  const std::string text = "\n" + runVehicle({"simulate", kPaper, kRail}).out;
  const std::string table = tableCalled("columns\n", text);
  const json read = json::parse(runVehicle({"simulate", kPaper, kRail, "--format", "json"}).out);
  std::size_t compared = 0;
  for (const json& row : read["tables"]["columns"]["rows"]) {
    const std::string name = row["column"], si = row["unit"];
    for (const std::string& line : linesOf(table)) {
      std::istringstream words(line);
      std::string column, unit;
      double lowest = 0.0, highest = 0.0, peak = 0.0;
      if (!(words >> column >> unit >> lowest >> highest >> peak) || column != name) continue;
      ++compared;
      const double ratio = peak / row["peak"].get<double>();
      const double factor = unit == si ? 1.0 : unit == "kN" ? 1e-3 : unit == "deg" ? 180.0 / M_PI : 1e3;
      EXPECT_NEAR(ratio, factor, 5e-5 * factor) << line;   // five digits are printed
      EXPECT_FALSE(unit == "rad" || unit == "m") << line;  // all of this run are small
      EXPECT_LT(std::abs(peak), 1e4) << line;
    }
  }
  EXPECT_GE(compared, 10u);
}

/// Numbers with an exponent that a unit of the right size would not need.
TEST(ShownUnits, NeedNoExponentForWhatAVehicleIs) {
  for (const Words& words :
       {Words{"info", kCoach}, Words{"info", kHertz}, Words{"info", kPaper}, Words{"info", kTrain}}) {
    for (const std::string& line : linesOf(runVehicle(words).out)) {
      EXPECT_FALSE(has(line, "e+0") || has(line, "e-0")) << words[1] << ": " << line;
    }
  }
}

}  // namespace
}  // namespace vehicle::test
