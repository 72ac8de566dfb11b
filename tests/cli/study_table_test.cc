// A study's tables for people, as CSV and as JSON, against the closed forms of one mass on a spring.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/studies.h"
#include "tests/support/source_tree.h"
#include "tests/support/tolerance.h"

namespace vehicle::test {
namespace {

using Json = nlohmann::json;

constexpr double kSlow = 20.0, kFast = 30.0;  // [m/s]

std::string five(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", number);
  return text;
}

/// "0.3 (-4.2 %)", and the room of a mark.
std::string changed(double value, double base, const char* mark = "  ") {
  char text[32];
  std::snprintf(text, sizeof text, " (%+.1f %%)", 100.0 * (value / base - 1.0));
  return five(value) + text + mark;
}

TEST(StudyTable, HoldsTheNumbersTheirChangeAndAMarkWhereALimitIsBroken) {
  const Columns page("120");
  const TestFolder folder;
  const ProgramRun run =
      runVehicle({"study", smallStudyIn(folder), "--output", folder.path("study.sqlite"), "--jobs", "1"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const double slow = rmsOfSmall(1e6, 20e3, kSlow), fast = rmsOfSmall(1e6, 20e3, kFast);
  const double sag = 1e3 * sagOfSmall(1e6);
  const std::vector<std::vector<std::string>> rows = {
      {"quantity", "unit", "base", "soft", "damped"},
      {"spring.stiffness_z", "kN/m", "1000  ", "500  ", "1000  "},
      {"spring.damping_z", "kN*s/m", "20  ", "20  ", "40  "},
      {"carbody.az.rms @ 72 km/h", "m/s^2", five(slow) + "  ", changed(rmsOfSmall(5e5, 20e3, kSlow), slow),
       changed(rmsOfSmall(1e6, 40e3, kSlow), slow)},
      {"carbody.az.rms @ 108 km/h", "m/s^2", five(fast) + "  ", changed(rmsOfSmall(5e5, 20e3, kFast), fast),
       changed(rmsOfSmall(1e6, 40e3, kFast), fast)},
      {"static.suspension.deflection", "mm", five(sag) + "  ", changed(2.0 * sag, sag, " !"), changed(sag, sag)},
  };
  std::string expected = "comparison\n";
  for (const std::vector<std::string>& row : rows) {
    std::string line;
    for (std::size_t j = 0; j < row.size(); ++j) {
      std::size_t width = 0;
      for (const std::vector<std::string>& each : rows) width = std::max(width, each[j].size());
      line += "  " + row[j] + std::string(width - row[j].size(), ' ');
    }
    expected += line.erase(line.find_last_not_of(' ') + 1) + '\n';
  }
  EXPECT_EQ(tableCalled("comparison", run.out), expected);
  EXPECT_TRUE(has(run.out, "\n! breaks a limit\n")) << run.out;
  EXPECT_TRUE(has(run.out, "\ndesigns        3\nevaluated      3\nfailed         0\nwithin limits  2\n")) << run.out;
  // The softest is the best of its speed, but out of the limit.
  const std::vector<std::string> best = linesOf(tableCalled("smallest carbody.az.rms, worst of 2 within", run.out));
  ASSERT_GE(best.size(), 4u) << run.out;
  const bool base_is_best = std::max(slow, fast) < std::max(rmsOfSmall(1e6, 40e3, kSlow), rmsOfSmall(1e6, 40e3, kFast));
  EXPECT_TRUE(has(best[best.size() - 2], base_is_best ? "  base " : "  damped ")) << run.out;
  EXPECT_TRUE(has(best[best.size() - 1], base_is_best ? "  damped " : "  base ")) << run.out;
  // And in which case the worst stands.
  EXPECT_TRUE(has(run.out, "  worst at  ")) << run.out;
  for (std::size_t i = best.size() - 2; i < best.size(); ++i) {
    const bool is_base = has(best[i], "  base ");
    const double c = is_base ? 20e3 : 40e3;
    const bool at_slow = rmsOfSmall(1e6, c, kSlow) >= rmsOfSmall(1e6, c, kFast);
    EXPECT_TRUE(has(best[i], at_slow ? "  72 km/h  " : "  108 km/h  ")) << best[i];
  }
}

TEST(StudyTable, JsonAndCsvHoldTheNumbersOfTheClosedForm) {
  const TestFolder folder;
  const std::string database = folder.path("study.sqlite");
  const ProgramRun json = runVehicle({"study", smallStudyIn(folder), "--output", database, "--format", "json"});
  ASSERT_EQ(json.status, 0) << json.err;
  const Json answer = Json::parse(json.out);
  EXPECT_EQ(answer["facts"]["designs"]["value"], 3);
  EXPECT_EQ(answer["facts"]["within limits"]["value"], 2);
  const Json rows = answer["tables"]["comparison"]["rows"];
  ASSERT_EQ(rows.size(), 15u);  // 3 designs of 2 parameters and 3 metrics
  EXPECT_EQ(rows[5]["design"], "soft");
  EXPECT_EQ(rows[5]["quantity"], "spring.stiffness_z");
  EXPECT_EQ(rows[5]["value"], 5e5);
  EXPECT_TRUE(rows[5]["change"].is_null());
  EXPECT_EQ(rows[8]["quantity"], "carbody.az.rms @ 108 km/h");
  EXPECT_EQ(rows[8]["unit"], "m/s^2");
  // Both are closed forms: rounding of some ten operations.
  const double soft = rmsOfSmall(5e5, 20e3, kFast), base = rmsOfSmall(1e6, 20e3, kFast);
  EXPECT_WITHIN(rows[8]["value"].get<double>(), soft, 1e-13);
  EXPECT_WITHIN(rows[8]["change"].get<double>(), 100.0 * (soft / base - 1.0), 1e-11);
  EXPECT_TRUE(rows[8]["keeps limit"].is_null());
  EXPECT_WITHIN(rows[9]["value"].get<double>(), sagOfSmall(5e5), 1e-15);
  EXPECT_EQ(rows[9]["keeps limit"], false);
  EXPECT_EQ(rows[4]["keeps limit"], true);

  const ProgramRun csv = runVehicle({"study", "show", database, "--format", "csv"});
  ASSERT_EQ(csv.status, 0) << csv.err;
  const std::vector<std::string> lines = linesOf(csv.out);
  EXPECT_EQ(lines[0], "id,design,quantity,unit,value,change [%],keeps limit");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::string begin = std::to_string(rows[i]["id"].get<int>()) + ",";
    for (const char* column : {"design", "quantity", "unit"}) begin += rows[i][column].get<std::string>() + ",";
    ASSERT_EQ(lines.at(i + 1).substr(0, begin.size()), begin);
    EXPECT_EQ(std::stod(lines[i + 1].substr(begin.size())), rows[i]["value"].get<double>());
  }
  EXPECT_EQ(lines.at(16), "");
  EXPECT_TRUE(lines.at(17).starts_with("id,design,spring.stiffness_z [N/m],spring.damping_z [N*s/m],")) << lines[17];
}

TEST(StudyTable, ShowPrintsTheTablesThatTheRunPrinted) {
  const TestFolder folder;
  const std::string database = folder.path("study.sqlite");
  const ProgramRun run = runVehicle({"study", smallStudyIn(folder), "--output", database});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto tables = [](const std::string& text) {
    const std::size_t from = text.find("\ncomparison\n");
    return text.substr(from, text.find("\n\n", text.find("\nsmallest ")) - from);
  };
  // The files of the study may be gone by then.
  for (const char* name : {"study.xml", "v.xml", "s.xml"}) std::filesystem::remove(folder.path(name));
  const ProgramRun shown = runVehicle({"study", "show", database});
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_GT(tables(run.out).size(), 500u);
  EXPECT_EQ(tables(shown.out), tables(run.out));
  EXPECT_TRUE(has(shown.out, "written by     vehicle " VEHICLE_VERSION "\n")) << shown.out;
  EXPECT_EQ(folder.entries(), 1u);
}

// Indices have an interval: no two columns of a name, or JSON would keep one of them.
TEST(StudyTable, InfluencesHaveTheirIntervalsInEveryFormat) {
  const TestFolder folder;
  const std::string varied = R"(<vary parameter="carbody.mass" from="50 t" to="60 t"/>
  <vary parameter="secondary.damping_z" from="50 kN*s/m" to="150 kN*s/m"/>
  <plan kind="saltelli" size="32"/>)";
  const std::string study = folder.file("study.xml", paperStudy(varied));
  const std::string database = folder.path("study.sqlite");
  const ProgramRun json = runVehicle({"study", study, "--output", database, "--format", "json"});
  ASSERT_EQ(json.status, 0) << json.err;
  const Json rows = Json::parse(json.out)["tables"]["what the factors do"]["rows"];
  ASSERT_EQ(rows.size(), 2u);
  for (const Json& row : rows) {
    EXPECT_EQ(row.size(), 10u);
    for (const char* index : {"first-order index", "total index"}) {
      EXPECT_LE(row[std::string(index) + " low"], row[index]);
      EXPECT_GE(row[std::string(index) + " high"], row[index]);
    }
  }
  const ProgramRun table = runVehicle({"study", "show", database});
  const std::vector<std::string> lines = linesOf(tableCalled("what the factors do to carbody.az.rms", table.out));
  ASSERT_EQ(lines.size(), 4u) << table.out;
  char mass[80];
  const auto index = [&](const std::string& end) { return rows[0]["first-order index" + end].get<double>(); };
  std::snprintf(mass, sizeof mass, "  carbody.mass         %.3f  (%6.3f .. %5.3f)", index(""), index(" low"),
                index(" high"));
  EXPECT_EQ(lines[2].substr(0, std::string(mass).size()), mass);
}

// Pairs: y = the r.m.s. of a linear vehicle over waves, so masses and dampers act together.
TEST(StudyTable, PairsOfFactorsStandInEveryFormat) {
  const TestFolder folder;
  const std::string varied = R"(<vary parameter="carbody.mass" from="50 t" to="60 t"/>
  <vary parameter="secondary.damping_z" from="50 kN*s/m" to="150 kN*s/m"/>
  <vary parameter="secondary.stiffness_z" from="1 MN/m" to="4 MN/m"/>
  <plan kind="saltelli" size="32" second_order="yes"/>)";
  const std::string study = folder.file("study.xml", paperStudy(varied));
  const std::string database = folder.path("study.sqlite");
  const ProgramRun json = runVehicle({"study", study, "--output", database, "--format", "json"});
  ASSERT_EQ(json.status, 0) << json.err;
  EXPECT_EQ(json.err, "");
  const Json answer = Json::parse(json.out);
  EXPECT_EQ(answer["facts"]["designs"]["value"], 1 + 32 * 8);
  const Json rows = answer["tables"]["what pairs of factors do"]["rows"];
  ASSERT_EQ(rows.size(), 3u);
  for (const Json& row : rows) {
    EXPECT_EQ(row["metric"], "carbody.az.rms");
    EXPECT_LE(row["second-order index low"], row["second-order index"]);
    EXPECT_GE(row["second-order index high"], row["second-order index"]);
  }
  const ProgramRun table = runVehicle({"study", "show", database});
  const std::string pairs = tableCalled("what pairs of factors do together to carbody.az.rms", table.out);
  const std::vector<std::string> lines = linesOf(pairs);
  ASSERT_EQ(lines.size(), 5u) << table.out;
  double before = 10.0;  // the largest first
  for (std::size_t i = 2; i < 5; ++i) {
    const double index = std::stod(lines[i].substr(lines[i].find_first_of("-0123456789")));
    EXPECT_LE(std::abs(index), before + 1e-3) << pairs;
    before = std::abs(index);
  }
}

// The published case: 31 designs of which five have no frequency of pitch, and everything else.
TEST(StudyTable, ValuesThatAreMissingAreEmptyInEveryFormatAndTheirReasonIsCounted) {
  const Columns page("120");
  const TestFolder folder;
  const std::string study = sourcePath("tests/cli/cases/mode-name-sweep.xml");
  const std::string database = folder.path("m.sqlite"), csv = folder.path("m.csv");
  const ProgramRun run = runVehicle({"study", study, "--output", database, "--export", csv, "--quiet", "--strict"});
  // A value that is missing is no warning; the two softest springs come down by 0.5 m and more.
  EXPECT_EQ(run.status, 4) << run.err;
  EXPECT_EQ(linesOf(run.err).size(), 1u) << run.err;
  EXPECT_TRUE(has(run.err, "mode-name-sweep.xml:2: warning: <study>: 2 of 31 designs, the first is #0: a spring is ")) << run.err;
  EXPECT_TRUE(has(run.err, "[REST_DEFLECTION]\n")) << run.err;
  EXPECT_TRUE(has(run.out,
                  "\ndesigns              31\nevaluated            31\nfailed               0\n"
                  "with values missing  5\nwith warnings        2\n"))
      << run.out;
  const std::string why = "the mode is overdamped: its roots are real, it does not oscillate";
  EXPECT_EQ(tableCalled("missing values", run.out),
            "missing values\n"
            "  designs  metric                        why\n"
            "        5  mode.carbody pitch.frequency  " +
                why + "\n");
  EXPECT_TRUE(has(run.out, "\nmode.carbody pitch.frequency: 5 of 30 designs have no value and are left out\n"))
      << run.out;
  EXPECT_TRUE(has(run.out, "\n- no value: 5 of 31 designs lack one or more, for the reasons above\n")) << run.out;
  // #2 is the design of 0.6 MN/m: bounce at 0.7112 Hz, as known from elsewhere.
  EXPECT_TRUE(has(run.out, "\n  #2              600  ")) << run.out;
  EXPECT_TRUE(has(run.out, "  0.71122 (-44.1 %)  -\n")) << run.out;
  const std::vector<std::string> lines = linesOf(textOf(csv));
  ASSERT_EQ(lines.size(), 32u);
  EXPECT_TRUE(lines[4].starts_with("3,#2,done,6e+05,")) << lines[4];
  EXPECT_TRUE(lines[4].ends_with(",,\"mode.carbody pitch.frequency: " + why + "\"")) << lines[4];
  EXPECT_TRUE(lines[32 - 1].ends_with(",")) << lines[31];  // nothing to say of a whole design

  const ProgramRun json = runVehicle({"study", "show", database, "--format", "json"});
  ASSERT_EQ(json.status, 0) << json.err;
  const Json answer = Json::parse(json.out);
  EXPECT_EQ(answer["tables"]["missing values"]["rows"][0]["designs"], 5);
  int nulls = 0;
  for (const Json& row : answer["tables"]["comparison"]["rows"]) {
    if (!row["value"].is_null()) continue;
    EXPECT_EQ(row["quantity"], "mode.carbody pitch.frequency");
    EXPECT_TRUE(row["change"].is_null());
    ++nulls;
  }
  EXPECT_EQ(nulls, 5);
}

TEST(StudyTable, ManyParametersStayWithinThePage) {
  const Columns page("120");
  const TestFolder folder;
  std::string vary;
  for (const char* name : {"carbody.mass", "carbody.pitch_inertia", "front_bogie.mass", "rear_bogie.mass",
                           "primary.stiffness_z", "primary.damping_z", "secondary.stiffness_z", "secondary.damping_z",
                           "front.x", "rear.x"}) {
    vary += std::string("<vary parameter=\"") + name + "\" kind=\"relative\" from=\"90 %\" to=\"110 %\"/>\n  ";
  }
  const std::string study = folder.file(
      "study.xml", paperStudy(vary + R"(<vary parameter="speed" from="50 km/h" to="150 km/h" count="5"/>
  <plan kind="sobol" size="64"/>)",
                              R"(<metric name="carbody.az.rms"/> <metric name="secondary_front.deflection.peak"/>
  <objective metric="carbody.az.rms" goal="minimise"/>
  <objective metric="secondary_front.deflection.peak" goal="minimise"/>)"));
  const ProgramRun run = runVehicle({"study", study, "--output", folder.path("study.sqlite")});
  ASSERT_EQ(run.status, 0) << run.err;
  for (const std::string& line : linesOf(run.out)) EXPECT_LE(line.size(), 120u) << line;
}

}  // namespace
}  // namespace vehicle::test
