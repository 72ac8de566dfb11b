// Every command that takes a vehicle takes a train.
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "libvehicle/storage/csv.h"
#include "libvehicle/storage/hdf5.h"
#include "tests/cli/program.h"

namespace vehicle::test {
namespace {

using Json = nlohmann::json;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string kRun = R"(speed="20 m/s" duration="1 s" output_step="5 ms")";

// Three of the small vehicle, coupled.
std::string smallTrain(const std::string& file) {
  return "<train name=\"small-train\" format=\"1\">\n  <vehicle file=\"" + file +
         "\" name=\"wagon\" count=\"3\" spacing=\"10 m\"/>\n"
         "  <coupling stiffness_z=\"100 kN/m\" damping_z=\"5 kN*s/m\" end_x=\"5 m\"/>\n</train>\n";
}

TEST(TrainCommands, CheckJudgesTrainsAndHoldsScenariosAgainstThem) {
  const TestFolder folder;
  folder.file("v.xml", smallVehicle());
  const std::string train = folder.file("t.xml", smallTrain("v.xml"));
  EXPECT_EQ(runVehicle({"check", train}).out, train + ": ok\n");
  std::string text = smallScenario(kRun);
  text.insert(text.find("</scenario>"), R"(<initial_state><body name="wagon_4.carbody" z="1 mm"/></initial_state>)");
  const ProgramRun run = runVehicle({"check", train, folder.file("s.xml", text)});
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(has(run.out, "wagon_4.carbody")) << run.out;
  const std::string lost = folder.file("lost.xml", smallTrain("none.xml"));
  EXPECT_EQ(runVehicle({"check", lost}).out,
            lost +
                ":2: error: <train><vehicle>: file=\"none.xml\": cannot be read: No such file or directory; check the "
                "name of the file\n");
}

TEST(TrainCommands, InfoListsTheVehiclesFromTheFront) {
  const ProgramRun run = runVehicle({"info", model("trains/locomotive-and-coaches.xml"), "--format", "json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json told = Json::parse(run.out);
  EXPECT_EQ(told["facts"]["vehicle"]["value"], "locomotive-and-coaches");
  EXPECT_EQ(told["facts"]["vehicles"]["value"], 5);
  const Json rows = told["tables"]["vehicles"]["rows"];
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[0]["vehicle"], "locomotive_1");
  EXPECT_EQ(rows[4]["vehicle"], "coach_5");
  EXPECT_EQ(rows[1]["x"], -21.0);
  // A coach of 44.482 t on its rails: 436.4 kN.
  EXPECT_NEAR(rows[4]["static load"].get<double>(), 44.482e3 * 9.81, 1e-6);  // rounding of 1e5 N in sums
}

TEST(TrainCommands, SimulateWritesTheColumnsOfEveryVehicleAndKeepsAllFiles) {
  const TestFolder folder;
  const std::string vehicle = folder.file("v.xml", smallVehicle());
  const std::string train = folder.file("t.xml", smallTrain("v.xml"));
  const std::string scenario = folder.file("s.xml", smallScenario(kRun));
  const ProgramRun run = runVehicle({"simulate", train, scenario, "--output", folder.path("run.csv"), "--output",
                                     folder.path("run.h5"), "--quiet"});
  ASSERT_EQ(run.status, 0) << run.err;
  const TimeHistory history = readCsv(folder.path("run.csv")).orThrow();
  EXPECT_EQ(history.columns()[1].name.substr(0, 8), "wagon_1.");
  EXPECT_EQ(history.column("coupling_2.force").size(), 201u);
  const RunRecord record = readHdf5(folder.path("run.h5")).orThrow();
  ASSERT_EQ(record.inputs.size(), 3u);
  EXPECT_EQ(record.inputs[2].name, vehicle);
}

TEST(TrainCommands, ModesAndValidateTakeTrains) {
  const TestFolder folder;
  folder.file("v.xml", smallVehicle());
  const std::string train = folder.file("t.xml", smallTrain("v.xml"));
  const std::string scenario = folder.file("s.xml", smallScenario(kRun));
  const ProgramRun modes = runVehicle({"modes", train, "--format", "csv"});
  EXPECT_EQ(modes.status, 0) << modes.err;
  EXPECT_TRUE(has(modes.out, "wagon_2.")) << modes.out;
  const ProgramRun validated = runVehicle({"validate", train, scenario});
  EXPECT_EQ(validated.status, 0) << validated.out << validated.err;
}

TEST(TrainCommands, TheFlatFormOfAShippedTrainStandsTheComparisonWithTheOthers) {
  const ProgramRun run = runVehicle({"validate", model("trains/paper-three.xml"), model("scenarios/paper-20mps.xml"),
                                     "--format", "json", "--time-limit", "10 min"});
  EXPECT_EQ(run.status, 0) << run.out << run.err;
}

}  // namespace
}  // namespace vehicle::test
