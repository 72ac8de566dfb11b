// --speed of simulate and validate: one speed, a list, a range.
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace vehicle::test {
namespace {

using Json = nlohmann::json;

struct Files {
  TestFolder folder;
  std::string vehicle = folder.file("v.xml", smallVehicle());
  std::string scenario = folder.file("s.xml", smallScenario(R"(speed="20 m/s" duration="1 s" output_step="5 ms")"));
};

Json simulated(const Files& files, std::vector<std::string> more) {
  std::vector<std::string> words = {"simulate", files.vehicle, files.scenario, "--format", "json"};
  words.insert(words.end(), more.begin(), more.end());
  const ProgramRun run = runVehicle(words);
  EXPECT_EQ(run.status, 0) << run.err;
  return Json::parse(run.out);
}

TEST(Speeds, OfARangeAreThoseWrittenOneByOneToTheBit) {
  const Files files;
  const Json range = simulated(files, {"--speed", "50:12.5:99 km/h, 30 m/s"});
  const std::vector<std::string> speeds = {"50 km/h", "62.5 km/h", "75 km/h", "87.5 km/h", "30 m/s"};
  const Json& rows = range["tables"]["columns"]["rows"];
  ASSERT_EQ(range["tables"]["runs"]["rows"].size(), speeds.size());
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const Json one = simulated(files, {"--speed", speeds[i]});
    const Json& columns = one["tables"]["columns"]["rows"];
    ASSERT_EQ(rows.size(), columns.size() * speeds.size());
    EXPECT_EQ(range["tables"]["runs"]["rows"][i]["speed"], one["facts"]["speed"]["value"]);
    for (std::size_t j = 0; j < columns.size(); ++j) {
      Json expected = columns[j];  // each column, speed by speed
      expected["speed"] = one["facts"]["speed"]["value"];
      EXPECT_EQ(rows[j * speeds.size() + i], expected);
    }
  }
}

TEST(Speeds, HistoriesAreThoseOfSingleRunsAndAreCalledByTheirSpeed) {
  const Files files;
  simulated(files, {"--speed", "50:50:100 km/h", "--output", files.folder.path("run.csv"), "--output",
                    files.folder.path("run.h5")});
  for (const char* speed : {"50", "100"}) {
    const std::string single = files.folder.path("single.csv");
    simulated(files, {"--speed", std::string(speed) + " km/h", "--output", single});
    EXPECT_EQ(textOf(files.folder.path("run-" + std::string(speed) + "kmh.csv")), textOf(single));
    EXPECT_FALSE(textOf(files.folder.path("run-" + std::string(speed) + "kmh.h5")).empty());
  }
  EXPECT_EQ(files.folder.entries(), 7u);  // two inputs, four histories, the single one
}

TEST(Speeds, AFileOfSomeoneElseStopsAllRunsBeforeTheFirst) {
  const Files files;
  const std::string foreign = files.folder.file("run-100kmh.csv", "not ours\n");
  const ProgramRun run = runVehicle({"simulate", files.vehicle, files.scenario, "--speed", "50 km/h, 100 km/h",
                                     "--output", files.folder.path("run.csv")});
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find(foreign), std::string::npos) << run.err;
  EXPECT_EQ(textOf(foreign), "not ours\n");
  EXPECT_EQ(files.folder.entries(), 3u);
}

TEST(Speeds, ThatAreNoneAreSaidToBeWithValueRuleAndRemedy) {
  const Files files;
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"60:20 km/h", "\"60:20 km/h\" is no range; write FROM:STEP:TO UNIT, e.g. \"80:10:160 km/h\""},
      {"60:20:120", "\"60:20:120\" has no unit; put it behind the last number, e.g. \"80:10:160 km/h\""},
      {"60:0:120 km/h", "\"60:0:120 km/h\" has \"0\" where a number > 0 is expected; write it as \"80:10:160 km/h\""},
      {"60:x:120 km/h", "\"60:x:120 km/h\" has \"x\" where a number > 0 is expected; write it as \"80:10:160 km/h\""},
      {"120:20:60 km/h", "\"120:20:60 km/h\" ends below its start; write FROM:STEP:TO UNIT with TO at or above FROM"},
      {"1:0.001:200 km/h", "\"1:0.001:200 km/h\" has more than 1000 speeds; take a larger step"},
      {"60 km/h, 60 km/h", "\"60 km/h, 60 km/h\" has 60 km/h twice; give each speed once"},
      {"60 km/h,", "\"60 km/h,\" has an empty item; put one comma between two speeds"},
      {"60, 70 km/h", "\"60\" has no unit; a speed is expected, e.g. \"72 km/h\""},
      {"-5 km/h", "\"-5 km/h\" must be finite and > 0; give a speed, e.g. \"72 km/h\""},
  };
  for (const char* command : {"simulate", "validate"}) {
    for (const auto& [speed, message] : wrong) {
      const ProgramRun run = runVehicle({command, files.vehicle, files.scenario, "--speed", speed});
      EXPECT_EQ(run.status, 2) << speed;
      EXPECT_EQ(run.err,
                std::string("vehicle ") + command + ": --speed: " + message + "; see vehicle " + command + " --help\n");
    }
  }
}

TEST(Speeds, MakeCasesOfValidate) {
  const Files files;
  const ProgramRun run = runVehicle({"validate", files.vehicle, files.scenario, "--speed", "50:25:100 km/h", "--method",
                                     "exact", "--method", "dopri5", "--format", "json"});
  EXPECT_EQ(run.status, 0) << run.err;
  const Json rows = Json::parse(run.out)["tables"]["cases"]["rows"];
  ASSERT_EQ(rows.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(rows[i]["speed"].get<double>(), (50.0 + 25.0 * static_cast<double>(i)) / 3.6, 1e-12);  // [m/s] rounding
    EXPECT_EQ(rows[i]["verdict"], "inside");
  }
}

}  // namespace
}  // namespace vehicle::test
