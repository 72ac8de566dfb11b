#include <algorithm>
#include <chrono>
#include <csignal>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace vehicle::test {
namespace {

using Json = nlohmann::json;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string kVehicle = model("vehicles/al-oraiqat-2017.xml");
const std::string kScenario = model("scenarios/paper-20mps.xml");

std::vector<std::string> with(const std::string& command, std::vector<std::string> options) {
  options.insert(options.begin(), {command, kVehicle, kScenario});
  return options;
}

struct Wrong {
  std::vector<std::string> arguments;
  std::string message;  // the whole of stderr
};

TEST(ThreadOptions, WhatIsWrongIsToldInOneLineWithStatusTwo) {
  const std::string see = "; see vehicle simulate --help\n";
  const std::vector<Wrong> cases = {
      {with("simulate", {"--threads", "0"}),
       "vehicle simulate: --threads: \"0\" must be a whole number 1..256, or auto" + see},
      {with("simulate", {"--threads", "two"}),
       "vehicle simulate: --threads: \"two\" must be a whole number 1..256, or auto" + see},
      {with("simulate", {"--threads", "300"}),
       "vehicle simulate: --threads: \"300\" must be a whole number 1..256, or auto" + see},
      {with("simulate", {"--method", "rk4", "--scheme", "stages", "--threads", "9"}),
       "vehicle: 9 threads for 4 equations: map auto gives every thread at least one; take at most 4\n"},
      {with("simulate", {"--scheme", "ring"}),
       "vehicle simulate: --scheme: \"ring\" is unknown; choose one of serial, stages, halo, pipeline, split" + see},
      {with("simulate", {"--scheme", "stage"}),
       "vehicle simulate: --scheme: \"stage\" is unknown; did you mean \"stages\"?" + see},
      {with("simulate", {"--method", "rk4", "--scheme", "stages", "--map", "paper", "--threads", "3"}),
       "vehicle: map paper divides the four equations of the source paper's vehicle among four threads; here are 3 "
       "threads; take 4, or map auto or body\n"},
      {with("simulate", {"--form", "mbs", "--threads", "2"}),
       "vehicle: the form mbs runs on one thread: Simbody computes all of its equations together; take --threads 1\n"},
      {with("simulate", {"--method", "dopri5", "--threads", "2"}),
       "vehicle: the method dopri5 runs on one thread: it chooses each step from the whole state; take --threads 1, or "
       "method rk4\n"},
      {with("profile", {"--realtime", "0 ms"}),
       "vehicle profile: --realtime: \"0 ms\" must be finite and > 0; see vehicle profile --help\n"},
      {with("profile", {"--realtime", "1 m"}),
       "vehicle profile: --realtime: \"1 m\" is a length; a time is expected, e.g. \"5 ms\"; see vehicle profile "
       "--help\n"},
      {with("profile", {"--realtime", "11 s"}),
       "vehicle: realtime: period = 11 s gives 0 steps in 10 s, must be 1..10000000\n"},
      {with("profile", {"--realtime", "1 ms", "--threads", "2"}),
       "vehicle: --threads has no effect: with --realtime one thread computes all equations; omit one of them\n"},
      {with("profile", {"--every", "0"}),
       "vehicle profile: --every: \"0\" must be a whole number 1..1000000; see vehicle profile --help\n"},
      {with("profile", {"--waiting", "spinn"}),
       "vehicle profile: --waiting: \"spinn\" is unknown; did you mean \"spin\"?; see vehicle profile --help\n"},
  };
  for (const Wrong& wrong : cases) {
    const ProgramRun run = runVehicle(wrong.arguments);
    EXPECT_EQ(run.status, 2) << wrong.message;
    EXPECT_EQ(run.out, "") << wrong.message;
    EXPECT_EQ(run.err, wrong.message);
  }
}

// Threads on a machine that other tests keep busy may take milliseconds a step: few steps.
std::string shortPaper(const TestFolder& folder) {
  return folder.file("s.xml", smallScenario(R"(speed="20 m/s" duration="300 ms" output_step="5 ms")"));
}

TEST(SimulateCommand, ThreadsChangeNoDigitOfItsColumns) {
  const TestFolder folder;
  const std::string scenario = shortPaper(folder);
  const auto columns = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"simulate", kVehicle, scenario, "--format", "json"});
    const ProgramRun run = runVehicle(options);
    EXPECT_EQ(run.status, 0) << run.err;
    return Json::parse(run.out);
  };
  const Json serial = columns({"--method", "rk4"});
  EXPECT_EQ(serial["facts"]["scheme"]["value"], "serial");
  EXPECT_EQ(serial["facts"]["threads"]["value"], 1);
  for (const char* scheme : {"stages", "halo", "pipeline"}) {
    const Json shared = columns({"--method", "rk4", "--threads", "2", "--scheme", scheme});
    EXPECT_EQ(shared["facts"]["scheme"]["value"], scheme);
    EXPECT_EQ(shared["facts"]["threads"]["value"], 2);
    EXPECT_EQ(shared["tables"]["columns"], serial["tables"]["columns"]) << scheme;
  }
}

TEST(SimulateCommand, WithAutoTheChoiceAndItsNumbersArePrinted) {
  const ProgramRun run = runVehicle(with("simulate", {"--method", "rk4", "--threads", "auto", "--format", "json"}));
  ASSERT_EQ(run.status, 0) << run.err;
  const Json told = Json::parse(run.out);
  EXPECT_NE(told["facts"]["chosen because"]["value"], "");
  int taken = 0;
  for (const Json& row : told["tables"]["ways to run it"]["rows"]) taken += row["taken"] == true ? 1 : 0;
  EXPECT_EQ(taken, 1) << run.out;
}

TEST(SimulateCommand, WithAutoARunThatCannotBeSharedSaysWhyItHasOneThread) {
  const TestFolder folder;
  const ProgramRun run =
      runVehicle({"simulate", kVehicle, shortPaper(folder), "--method", "dopri5", "--threads", "auto"});
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(has(run.err, "note: --threads auto is one thread: the method dopri5 runs on one thread: ")) << run.err;
}

TEST(ProfileCommand, TellsThreadsWaitsPathAndTimesAndWritesBothFiles) {
  const TestFolder folder;
  const ProgramRun run =
      runVehicle({"profile", kVehicle, shortPaper(folder), "--threads", "4", "--scheme", "stages", "--map", "paper",
                  "--format", "json", "--trace", folder.path("t.json"), "--timeline", folder.path("t.svg")});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "written: " + folder.path("t.json") + "\nwritten: " + folder.path("t.svg") + "\n");
  const Json told = Json::parse(run.out);
  EXPECT_EQ(told["facts"]["scheme"]["value"], "stages");
  EXPECT_EQ(told["facts"]["threads"]["value"], 4);
  const Json& tables = told["tables"];
  ASSERT_EQ(tables["time of a step"]["rows"].size(), 3u);
  for (const Json& row : tables["time of a step"]["rows"]) EXPECT_GT(row["median"], 0.0);
  ASSERT_EQ(tables["threads"]["rows"].size(), 4u);
  for (const Json& row : tables["threads"]["rows"]) {
    // The two shares of the trace are all of it; sums of thousands of spans round.
    EXPECT_NEAR(row["computing"].get<double>() + row["waiting"].get<double>(), 100.0, 1e-9);
  }
  ASSERT_EQ(tables["who computes what"]["rows"].size(), 4u);
  EXPECT_EQ(tables["who computes what"]["rows"][0]["which"], "rear_bogie bounce (5)");
  EXPECT_EQ(tables["who computes what"]["rows"][1]["which"], "carbody bounce (2), the rail (6)");
  EXPECT_EQ(tables["cores"]["rows"].size(), 4u);
  double path = 0.0;
  for (const Json& row : tables["critical path of the traced steps"]["rows"]) path += row["share"].get<double>();
  EXPECT_NEAR(path, 100.0, 1e-6);  // each step's walk ends where it began, to the rounding of times since the start
  const Json& step = tables["step times of thread 1, all steps"]["rows"][0];
  EXPECT_EQ(step["count"], told["facts"]["steps"]["value"]);
  EXPECT_LE(step["p50"], step["p99"]);
  EXPECT_LE(step["p99"], step["p99.9"]);

  const Json trace = Json::parse(textOf(folder.path("t.json")));
  int spans = 0, waits = 0;
  for (const Json& event : trace["traceEvents"]) {
    if (event["ph"] != "X") continue;
    ++spans;
    waits += event["cat"] == "wait" ? 1 : 0;
    EXPECT_GE(event["dur"], 0.0);
    EXPECT_EQ(event["args"]["step"].get<long>() % 16, 0);
  }
  EXPECT_GT(spans, 50);  // 19 steps of four threads, each with a span at least
  EXPECT_GT(waits, 0);
  EXPECT_TRUE(has(textOf(folder.path("t.svg")), "thread 4</text>"));
}

TEST(ProfileCommand, OfThreadsLeftOpenTakesAMapWhereverItEnds) {
  const TestFolder folder;
  const ProgramRun run = runVehicle({"profile", kVehicle, shortPaper(folder), "--threads", "auto", "--method", "rk4",
                                     "--map", "paper", "--format", "json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string scheme = Json::parse(run.out)["facts"]["scheme"]["value"];
  EXPECT_TRUE(scheme == "serial" || scheme == "stages" || scheme == "halo") << scheme;
}

TEST(ProfileCommand, TracesTheTwoThreadsOfASplitVehicle) {
  const TestFolder folder;
  const ProgramRun run = runVehicle(
      {"profile", kVehicle, shortPaper(folder), "--threads", "2", "--method", "rk4_split", "--format", "json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json told = Json::parse(run.out);
  EXPECT_EQ(told["facts"]["traced steps"]["value"].get<long>(),
            (told["facts"]["steps"]["value"].get<long>() + 15) / 16);
  ASSERT_EQ(told["tables"]["who computes what"]["rows"].size(), 2u);
  for (const Json& row : told["tables"]["threads"]["rows"]) EXPECT_GT(row["computing"].get<double>(), 0.0);
}

TEST(ProfileCommand, SaysThatThreadsWereNotPinnedAndWhy) {
  const TestFolder folder;
  const ProgramRun run = runVehicle({"profile", kVehicle, shortPaper(folder), "--threads", "2", "--scheme", "halo",
                                     "--pinning", "free", "--format", "json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json told = Json::parse(run.out);
  for (const Json& row : told["tables"]["cores"]["rows"]) EXPECT_EQ(row["pinned"], false);
  EXPECT_NE(std::find(told["remarks"].begin(), told["remarks"].end(), "not pinned: not asked for"),
            told["remarks"].end());
}

TEST(ProfileCommand, OfTheSplitAndOfOneThreadWork) {
  const ProgramRun split = runVehicle(with("profile", {"--method", "rk4_split", "--threads", "2", "--quiet"}));
  EXPECT_EQ(split.status, 0) << split.err;
  EXPECT_EQ(split.err, "");
  EXPECT_TRUE(has(split.out, "rk4_split, best serial code")) << split.out;
  const ProgramRun one = runVehicle(with("profile", {"--threads", "1"}));
  EXPECT_EQ(one.status, 0) << one.err;
  EXPECT_TRUE(has(one.out, "the run stayed on the program's own thread")) << one.out;
}

TEST(ProfileCommand, InRealTimeStepsAreReleasedByTheClock) {
  const TestFolder folder;
  const std::string scenario =
      folder.file("s.xml", smallScenario(R"(speed="20 m/s" duration="400 ms" output_step="5 ms")"));
  const auto begin = std::chrono::steady_clock::now();
  const ProgramRun run =
      runVehicle({"profile", folder.file("v.xml", smallVehicle()), scenario, "--realtime", "2 ms", "--format", "json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(398));
  const Json facts = Json::parse(run.out)["facts"];
  EXPECT_EQ(facts["steps"]["value"], 200);
  EXPECT_EQ(facts["states read"]["value"].get<long>() + facts["states lost"]["value"].get<long>(), 200);
  // Rows are fed 50 ms ahead; on a machine that stands still for longer they are held, and it says so.
  if (facts["inputs held"]["value"] == 0) {
    EXPECT_EQ(facts["bits of the run without a clock"]["value"], true);
  }
  EXPECT_NE(facts["priority"]["value"], "");
}

TEST(ProfileCommand, CtrlCEndsARealTimeRunAndTellsWhatWasSeen) {
  const TestFolder folder;
  const std::string scenario =
      folder.file("s.xml", smallScenario(R"(speed="20 m/s" duration="600 s" output_step="5 ms")"));
  const ProgramRun run = runVehicle({"profile", folder.file("v.xml", smallVehicle()), scenario, "--realtime", "2 ms"},
                                    showsProgress, [](pid_t process) { kill(process, SIGINT); });
  EXPECT_EQ(run.status, 130) << run.err;
  EXPECT_TRUE(has(run.err, "of 300000 steps; the figures above end there")) << run.err;
  EXPECT_TRUE(has(run.out, "deadline misses")) << run.out;
}

TEST(ProfileCommand, ATraceOfASerialRunSaysThatThereIsNothingToShow) {
  const TestFolder folder;
  const std::string trace = folder.path("trace.json");
  const ProgramRun run =
      runVehicle({"profile", kVehicle, shortPaper(folder), "--threads", "1", "--trace", trace});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(textOf(trace).find("rk4 on the program's own thread, nothing to show"), std::string::npos);
}

TEST(ProfileCommand, CtrlCEndsALongProfile) {
  const TestFolder folder;
  const std::string scenario =
      folder.file("s.xml", smallScenario(R"(speed="20 m/s" duration="20000 s" output_step="50 ms")"));
  const ProgramRun run = runVehicle({"profile", kVehicle, scenario, "--threads", "2", "--scheme", "stages"},
                                    showsProgress, [](pid_t process) { kill(process, SIGINT); });
  EXPECT_EQ(run.status, 130) << run.err;
  EXPECT_EQ(run.err, "vehicle: interrupted; the threads were not watched to the end\n");
}

}  // namespace
}  // namespace vehicle::test
