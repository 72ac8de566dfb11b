// Runs of vehicles and tracks that users wrote: what the result has to be, and what has to be said of it.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "libvehicle/storage/csv.h"
#include "libvehicle/storage/hdf5.h"
#include "tests/cli/quarter_coach.h"
#include "tests/cli/studies.h"
#include "tests/support/source_tree.h"

namespace vehicle::test {
namespace {

using Json = nlohmann::json;

std::string caseFile(const std::string& name) { return sourcePath("tests/cli/cases/") + name + ".xml"; }

/// The json of a command that ends well.
Json reportOf(std::vector<std::string> words, int status = 0) {
  words.insert(words.end(), {"--format", "json", "--quiet"});
  const ProgramRun run = runVehicle(words);
  EXPECT_EQ(run.status, status) << run.err;
  return run.status == status ? Json::parse(run.out) : Json();
}

/// Its warnings of a code.
std::vector<Json> warningsOf(const Json& report, const std::string& code) {
  std::vector<Json> found;
  for (const Json& row : report["tables"]["warnings"]["rows"]) {
    if (row["code"] == code) found.push_back(row);
  }
  return found;
}

Json columnOf(const Json& report, const std::string& column) {
  for (const Json& row : report["tables"]["columns"]["rows"]) {
    if (row["column"] == column) return row;
  }
  ADD_FAILURE() << "no column " << column;
  return {};
}

double halfSineDip(double t) {
  const double s = 20.0 * t - 10.0;
  return s < 0.0 || s > 3.0 ? 0.0 : -5e-3 * std::sin(std::numbers::pi * s / 3.0);
}

// Integrated by hand. Allowed: 1e-4 of the load's dynamic part for peaks between samples, and 20 us, the step by hand.
TEST(RunCases, AWheelThatWouldLeaveTheRailIsSaidInEveryResult) {
  const std::vector<std::string> words = {"simulate", caseFile("quarter-hertz"), caseFile("lift")};
  const QuarterCoach coach;
  const LowestLoad truth = lowestLoad(coach, halfSineDip);
  ASSERT_LT(truth.load, 0.0);
  const std::vector<Json> rows = warningsOf(reportOf(words), "WHEEL_LOAD");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0]["subject"], "axle.load");
  EXPECT_EQ(rows[0]["unit"], "N");
  EXPECT_NEAR(rows[0]["value"].get<double>(), truth.load, 1e-4 * (coach.load - truth.load));
  EXPECT_NEAR(rows[0]["time"].get<double>(), truth.time, 20e-6);

  const TestFolder folder;
  std::vector<std::string> strict = words;
  strict.insert(strict.end(), {"--strict", "--format", "csv", "-q", "--output", folder.path("run.h5")});
  const ProgramRun run = runVehicle(strict);
  EXPECT_EQ(run.status, 4);
  EXPECT_EQ(linesOf(run.err).size(), 1u) << run.err;
  EXPECT_TRUE(run.err.starts_with("warning: axle.load: falls to -135.7 kN at t = 0.6508 s")) << run.err;
  EXPECT_TRUE(run.err.ends_with("[WHEEL_LOAD]\n")) << run.err;
  EXPECT_TRUE(has(run.out, "\ncode,file,line,subject,value,unit,time [s],message\nWHEEL_LOAD,,0,axle.load,-135711."))
      << run.out;
  std::string stored;
  for (const auto& [name, value] : readHdf5(folder.path("run.h5")).orThrow().attributes) {
    if (name == "warning 1") stored = value + '\n';
  }
  EXPECT_EQ(stored, run.err) << "the file holds the line";

  std::vector<std::string> validate = words;
  validate[0] = "validate";
  validate.insert(validate.end(), {"--form", "matrix", "--method", "exact", "--method", "rk4", "--strict", "--quiet"});
  const ProgramRun judged = runVehicle(validate);
  EXPECT_EQ(judged.status, 4);
  EXPECT_EQ(judged.err, run.err);
}

TEST(RunCases, EveryWheelThatPullsIsNamedTheWorstFirst) {
  const TestFolder folder;
  std::string fine = textOf(caseFile("high-waves"));
  fine = with(fine, "duration=\"2 s\"", "duration=\"2 s\" output_step=\"0.25 ms\"");
  const std::string output = folder.path("fine.csv");
  ASSERT_EQ(runVehicle({"simulate", caseFile("vehicle"), folder.file("fine.xml", fine), "--output", output}).status, 0);
  const TimeHistory history = readCsv(output).orThrow();
  const std::vector<Json> rows =
      warningsOf(reportOf({"simulate", caseFile("vehicle"), caseFile("high-waves")}), "WHEEL_LOAD");
  ASSERT_EQ(rows.size(), 4u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double> load = history.column(rows[i]["subject"].get<std::string>());
    const double truth = *std::min_element(load.begin(), load.end());
    EXPECT_LT(truth, 0.0) << rows[i];
    // Loads of wheelsets without mass jump with the rail's slope. The sample before the jump is up to 0.25 ms older than
    // its left side, which counts too, and such a load changes by 2 kN a millisecond.
    EXPECT_NEAR(rows[i]["value"].get<double>(), truth, 500.0);
    EXPECT_LE(rows[i]["value"].get<double>(), truth);
    if (i > 0) {
      EXPECT_LE(rows[i - 1]["value"].get<double>(), rows[i]["value"].get<double>());
    }
  }
}

// J s^2 + 2 c a^2 s + 2 k a^2 - m g h = 0 with a negative last term: of its two real roots one grows.
TEST(RunCases, AVehicleThatCannotStandIsSaidByEveryCommand) {
  const std::string wagon = caseFile("tips-over");
  const double k = 2.0 * 100e3 * 0.25 - 10e3 * 9.81 * 2.5, c = 2.0 * 1e3 * 0.25, J = 5e3;
  const TestFolder folder;
  std::string text = textOf(caseFile("two-waves"));
  const std::string periodic = "<initial_state from=\"periodic\"/>";
  const std::string zero = folder.file("zero.xml", with(text, periodic, ""));
  const std::vector<std::vector<std::string>> commands = {
      {"check", wagon}, {"info", wagon}, {"modes", wagon}, {"simulate", wagon, zero}};
  for (const std::vector<std::string>& words : commands) {
    const std::vector<Json> rows = warningsOf(reportOf(words), "CANNOT_STAND");
    ASSERT_EQ(rows.size(), 1u) << words[0];
    EXPECT_EQ(rows[0]["file"], wagon) << words[0];
    EXPECT_EQ(rows[0]["line"], 6) << words[0];
    EXPECT_EQ(rows[0]["subject"], "wagon pitch") << words[0];
    EXPECT_NEAR(rows[0]["value"].get<double>(), std::sqrt(-k / J), 1e-9) << words[0];  // rounding of an eigenvalue
    std::vector<std::string> strict = words;
    strict.insert(strict.end(), {"--strict", "--quiet"});
    EXPECT_EQ(runVehicle(strict).status, 4) << words[0];
  }
  double growth = 0.0;
  const Json modes = reportOf({"modes", wagon});
  for (const Json& mode : modes["tables"]["modes"]["rows"]) {
    growth = std::max(growth, mode["real"].get<double>());
  }
  EXPECT_NEAR(growth, (-c + std::sqrt(c * c - 4.0 * J * k)) / (2.0 * J), 1e-9);

  const ProgramRun refused = runVehicle({"simulate", wagon, caseFile("two-waves")});
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(linesOf(refused.err).size(), 1u) << refused.err;
  EXPECT_TRUE(
      refused.err.starts_with(caseFile("two-waves") + ":5: error: <scenario><initial_state>: from=\"periodic\""))
      << refused.err;
  // ln 2 over the root, 6.1992 1/s
  EXPECT_TRUE(has(refused.err, "one doubles every 0.112 s")) << refused.err;
}

// e^(6.1992 * 10) = 1e26.9: methods that keep an accuracy would take ever shorter steps.
TEST(RunCases, ValidateRefusesAMotionThatGrowsBeyondAnyComparisonAtOnce) {
  const TestFolder folder;
  const std::string zero =
      folder.file("zero.xml", with(textOf(caseFile("two-waves")), "<initial_state from=\"periodic\"/>", ""));
  const ProgramRun run = runVehicle({"validate", caseFile("tips-over"), zero});
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(has(run.err, "its motion grows 1e27-fold over 10 s, beyond any comparison")) << run.err;
  EXPECT_EQ(linesOf(run.err).size(), 1u) << run.err;
}

TEST(RunCases, WhatHoldsOfEqualVehiclesOfATrainIsSaidOnce) {
  const TestFolder folder;
  const std::string train =
      folder.file("train.xml", "<train name=\"t\" format=\"1\">\n  <vehicle file=\"" + caseFile("tips-over") +
                                   "\" count=\"3\" spacing=\"8 m\"/>\n</train>\n");
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"check", train}, {"simulate", train, caseFile("scenario")}}) {
    EXPECT_EQ(warningsOf(reportOf(words), "CANNOT_STAND").size(), 1u) << words[0];
  }
}

TEST(RunCases, AProfileSaysWhatIsDoubtfulOfTheVehicle) {
  const std::vector<std::string> words = {
      "profile", caseFile("tips-over"), caseFile("scenario"), "--strict", "--quiet", "--threads", "1"};
  const ProgramRun run = runVehicle(words);
  EXPECT_EQ(run.status, 4);
  EXPECT_TRUE(run.err.starts_with(caseFile("tips-over") + ":6: warning: wagon pitch: ")) << run.err;
  EXPECT_EQ(linesOf(run.err).size(), 1u) << run.err;
}

TEST(RunCases, WhatARunDoesNotUseOfItsTrackIsNotedOnceByEveryCommandThatRuns) {
  const TestFolder folder;
  const std::string loco = caseFile("short-pitch-loco"), dip = caseFile("dip-left-rail");
  const std::string files = "  <vehicle file=\"" + loco + "\"/> <scenario file=\"" + dip + "\"/>\n";
  const std::string study = folder.file("study.xml", "<study name=\"s\" format=\"1\">\n" + files +
                                                         R"(  <vary parameter="speed" values="10 m/s, 20 m/s"/>
  <metric name="carbody.az.rms"/>
</study>
)");
  const std::string suite = folder.file("suite.xml", "<suite name=\"s\" format=\"1\">\n" + files +
                                                         R"(  <speed value="10 m/s"/> <speed value="20 m/s"/>
  <form name="flat"/> <form name="matrix"/> <method name="exact"/>
</suite>
)");
  const std::vector<std::vector<std::string>> commands = {
      {"simulate", loco, dip},
      {"profile", loco, dip, "--threads", "1"},
      {"validate", loco, dip, "--form", "flat", "--form", "matrix", "--method", "exact"},
      {"validate", suite},
      {"study", study, "--output", folder.path("s.sqlite")}};
  for (const std::vector<std::string>& words : commands) {
    const ProgramRun run = runVehicle(words);
    EXPECT_EQ(run.status, 0) << words[0] << run.err;
    std::size_t notes = 0;
    for (const std::string& line : linesOf(run.err)) notes += line.starts_with("note: " + dip + ":5: rail=") ? 1u : 0u;
    EXPECT_EQ(notes, 1u) << words[0] << run.err;
  }
}

// Contacts at 1265 rad/s and a step of 100 ms, where rk4 allows 2.78 / 1265 = 2.2 ms: the run ends in infinity.
TEST(RunCases, ARunThatEndsInInfinitySaysWhy) {
  const ProgramRun run =
      runVehicle({"simulate", caseFile("metro"), caseFile("bump"), "--method", "rk4", "--step", "100 ms", "--quiet"});
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(linesOf(run.err).size(), 1u) << run.err;
  EXPECT_TRUE(has(run.err, " is not finite at t = ")) << run.err;
  EXPECT_TRUE(run.err.ends_with("[UNSTABLE_STEP]\n")) << run.err;
}

TEST(RunCases, TheLastSampleIsTheEndOfTheRun) {
  const TestFolder folder;
  const struct {
    const char *vehicle, *scenario;
    double step, end;
  } cases[] = {{"short-pitch-loco", "uneven-end", 5.7, 3600.0}, {"vehicle", "duration", 7e-3, 2.5033}};
  for (const auto& each : cases) {
    const std::string csv = folder.path(std::string(each.scenario) + ".csv");
    const Json report = reportOf({"simulate", caseFile(each.vehicle), caseFile(each.scenario), "--output", csv});
    EXPECT_EQ(report["facts"]["end of run"]["value"].get<double>(), each.end);
    const std::vector<double> time = readCsv(csv).orThrow().column("time");
    const std::size_t whole = static_cast<std::size_t>(std::floor(each.end / each.step));
    ASSERT_EQ(time.size(), whole + 2);
    EXPECT_EQ(time.back(), each.end);
    EXPECT_DOUBLE_EQ(time[whole], each.step * static_cast<double>(whole));
  }
}

// Wheels on contact springs swing at 200 Hz, samples are 5 ms apart. The truth is the largest of 100 samples a period,
// which may miss (pi / 100)^2 / 2 = 5e-4 of it; a run finds it to 2e-4, and rk4 at its own step to 5e-4.
TEST(RunCases, PeaksDoNotDependOnTheOutputStep) {
  const TestFolder folder;
  const std::string coarse = folder.file("coarse.xml", with(textOf(caseFile("bump")), "\"150 m\"", "\"40 m\""));
  const std::string fine =
      folder.file("fine.xml", with(textOf(coarse), "\"40 m\"", "\"40 m\" output_step=\"0.05 ms\""));
  const std::string output = folder.path("fine.h5");
  const std::vector<std::string> at = {"--speed", "80 km/h"};
  ASSERT_EQ(runVehicle({"simulate", caseFile("metro"), fine, "--output", output, at[0], at[1]}).status, 0);
  const TimeHistory history = readHdf5(output).orThrow().history;
  for (const std::string method : {"exact", "rk4"}) {
    const Json report = reportOf({"simulate", caseFile("metro"), coarse, "--method", method, at[0], at[1]});
    for (const std::string column : {"ws1.az", "ws1.load", "ws4.load", "bogie_A.az", "car.az", "rubber_1.force"}) {
      const std::vector<double> samples = history.column(column);
      const auto [lowest, highest] = std::minmax_element(samples.begin(), samples.end());
      const double about = samples.front();  // at rest before the bump
      const double allowed = 1e-3 * std::max(*highest - about, about - *lowest);
      const Json found = columnOf(report, column);
      EXPECT_NEAR(found["min"].get<double>(), *lowest, allowed) << column << " by " << method;
      EXPECT_NEAR(found["max"].get<double>(), *highest, allowed) << column << " by " << method;
    }
    EXPECT_TRUE(report["tables"]["warnings"]["rows"].empty()) << method;
  }
}

// Dampers as stiff as rods make one body of carbody and bogies: 75 t, its pitch inertia with the bogies at their places,
// on the primary springs. Slip of force / damping, 10 kN over 13 mm/s: 1e6 N s/m of the damping. The rest of the
// difference is rounding, and may be what the warning says; without one 2e-6, for peaks between samples.
TEST(RunCases, RoundingThatShowsIsSaidAndIsNoLarger) {
  const TestFolder folder;
  const std::string rigid = folder.file("rigid.xml", R"(<vehicle name="rigid" format="1">
  <element name="p" stiffness_z="3040 kN/m" damping_z="30 kN*s/m"/>
  <body name="carbody" mass="75 t" pitch_inertia="319.76125 t*m^2" motion="z pitch"/>
  <wheelset name="w1" x="5.225 m"/> <wheelset name="w2" x="2.225 m"/>
  <wheelset name="w3" x="-2.225 m"/> <wheelset name="w4" x="-5.225 m"/>
  <suspension name="p1" element="p" upper="carbody" lower="w1" x="3.725 m"/>
  <suspension name="p2" element="p" upper="carbody" lower="w2" x="3.725 m"/>
  <suspension name="p3" element="p" upper="carbody" lower="w3" x="-3.725 m"/>
  <suspension name="p4" element="p" upper="carbody" lower="w4" x="-3.725 m"/>
</vehicle>
)");
  const double right =
      columnOf(reportOf({"simulate", rigid, caseFile("scenario")}), "carbody.az")["peak"].get<double>();
  const struct {
    std::string damping;
    double value;
    bool is_warned;
  } cases[] = {{"1e10 N*s/m", 1e10, false}, {"1e12 N*s/m", 1e12, false}, {"1e13 N*s/m", 1e13, false},
               {"1e14 N*s/m", 1e14, true},  {"1e17 N*s/m", 1e17, true},  {"1e20 N*s/m", 1e20, true}};
  for (const auto& each : cases) {
    const std::string file = folder.file("v.xml", with(textOf(caseFile("damping-1e20")), "1e20 N*s/m", each.damping));
    const Json report = reportOf({"simulate", file, caseFile("scenario")});
    const std::vector<Json> rows = warningsOf(report, "ILL_CONDITIONED");
    EXPECT_EQ(rows.size(), each.is_warned ? 1u : 0u) << each.damping;
    const double said = 2e-6 + (rows.empty() ? 0.0 : rows[0]["value"].get<double>());
    const double found = columnOf(report, "carbody.az")["peak"].get<double>();
    EXPECT_NEAR(found, right, (1e6 / each.value + said) * right) << each.damping;
    EXPECT_EQ(runVehicle({"check", file, "--strict"}).status, each.is_warned ? 4 : 0) << each.damping;
  }
}

}  // namespace
}  // namespace vehicle::test
