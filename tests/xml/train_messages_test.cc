// What is said of a train file and of the vehicle files that it names, word for word.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/xml/reader.h"
#include "libvehicle/xml/writer.h"
#include "tests/xml/files.h"

namespace vehicle {
namespace {

using test::Spoilt;
using test::withLine;

TEST(TrainReader, EveryWrongLineIsTold) {
  const std::vector<Spoilt> cases = {
      {1, R"(<train format="1">)",
       R"(a.xml:1: error: <train>: attribute "name" is missing; write e.g. name="three-coaches"
)"},
      {2, "", "a.xml:1: error: <train>: has no <vehicle>; a train has at least one\n"},
      {2, R"(<vehicle count="3" spacing="26 m"/>)",
       R"(a.xml:2: error: <train><vehicle>: attribute "file" is missing; write e.g. file="../vehicles/coach.xml"
)"},
      {2, R"(<vehicle file="v.xml" count="3"/>)",
       R"(a.xml:2: error: <train><vehicle>: attribute "spacing" is missing; write e.g. spacing="26 m"
)"},
      {2, R"(<vehicle file="v.xml" count="0" spacing="26 m"/>)",
       R"(a.xml:2: error: <train><vehicle>: count="0"; must be from 1 to 10000
)"},
      {2, R"(<vehicle file="v.xml" count="3" spacing="0 m"/>)",
       R"(a.xml:2: error: <train><vehicle>: spacing="0 m"; must be > 0
)"},
      {2, R"(<vehicle file="v.xml" count="3" spacing="26"/>)",
       R"(a.xml:2: error: <train><vehicle>: spacing="26" has no unit; a length is expected, e.g. "3.725 m"
)"},
      {2, R"(<vehicle file="v.xml" name="the coach" spacing="26 m"/>)",
       R"(a.xml:2: error: <train><vehicle>: name="the coach" is no name; names have up to 64 letters a-z, A-Z, digits, "_" and "-", and begin with a letter or digit
)"},
      {2, R"(<vehicle file="v.xml" count="6000" spacing="26 m"/> <vehicle file="v.xml" count="6000" spacing="26 m"/>)",
       "a.xml:1: error: <train>: has 12000 vehicles; must be at most 10000\n"},
      {3, R"(<coupling stiffness_z="50 kN*s/m" end_x="12.5 m"/>)",
       R"(a.xml:3: error: <train><coupling>: stiffness_z="50 kN*s/m" is a damping; a stiffness is expected, e.g. "3040 kN/m"
)"},
      {3, R"(<coupling stiffness_z="-50 kN/m" end_x="12.5 m"/>)",
       R"(a.xml:3: error: <train><coupling>: stiffness_z="-50 kN/m"; must be >= 0
)"},
      {3, R"(<coupling stiffness_z="50 kN/m" end_x="-12.5 m"/>)",
       R"(a.xml:3: error: <train><coupling>: end_x="-12.5 m"; must be > 0
)"},
      {3, R"(<couplings stiffness_z="50 kN/m" end_x="12.5 m"/>)",
       R"(a.xml:3: error: <train>: element <couplings> is unknown; did you mean <coupling>?
)"},
  };
  for (const Spoilt& each : cases) {
    const auto outcome = readTrainText(withLine(test::kTrainLines, each.line, each.instead), "a.xml");
    EXPECT_EQ(outcome.problems.text(), each.says);
    EXPECT_FALSE(outcome.value.has_value()) << each.instead;
  }
}

// A folder with a right vehicle and a train file of the given second line.
class TrainFolder : public ::testing::Test {
 protected:
  TrainFolder() {
    folder_ = std::filesystem::path(::testing::TempDir()) /
              ("vehicle_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
    put("v.xml", test::textOf(test::kVehicleLines));
  }
  std::string put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return path(name);
  }
  std::string train(const std::string& second_line) const {
    return put("t.xml", withLine(test::kTrainLines, 2, second_line));
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

TEST_F(TrainFolder, ATrainIsReadWithItsVehiclesAndIsAVehicle) {
  const std::string file = put("t.xml", test::textOf(test::kTrainLines));
  EXPECT_EQ(kindOf(file).value, FileKind::kTrain);
  EXPECT_EQ(readTrain(file).problems.text(), "");
  const Train train = readTrain(file).orThrow();
  EXPECT_EQ(train.vehicles[0].vehicle.name, "v");
  EXPECT_EQ(readVehicle(file).orThrow(), assembled(train));
  EXPECT_EQ(readVehicle(file).orThrow().bodies[2].name, "v_3.frame");
  // Parts keep the place where they were written.
  EXPECT_EQ(readVehicle(file).orThrow().bodies[2].origin.file, path("v.xml"));
  EXPECT_EQ(readVehicle(file).orThrow().suspensions.back().origin.file, file);
}

TEST_F(TrainFolder, AVehicleFileThatIsMissingOrNoVehicleIsToldByTheTrain) {
  const std::string file = train(R"(<vehicle file="lost.xml" spacing="26 m"/> <vehicle file="t.xml" spacing="26 m"/>)");
  EXPECT_EQ(readTrain(file).problems.text(),
            file +
                ":2: error: <train><vehicle>: file=\"lost.xml\": cannot be read: No such file or directory; check "
                "the name of the file\n" +
                file + ":2: error: <train><vehicle>: file=\"t.xml\" holds a <train>; a <vehicle> is expected here\n");
  EXPECT_EQ(readVehicle(file).problems.text(), readTrain(file).problems.text());
}

TEST_F(TrainFolder, ProblemsOfAVehicleFileAreToldOnceAtItsOwnPlace) {
  const std::string wrong =
      put("w.xml", withLine(test::kVehicleLines, 3, R"(<body name="frame" mass="0 t" motion="z"/>)"));
  const std::string file = train(R"(<vehicle file="w.xml" spacing="26 m"/> <vehicle file="w.xml" spacing="26 m"/>)");
  EXPECT_EQ(readTrain(file).problems.text(), wrong + ":3: error: <vehicle><body>: mass=\"0 t\"; must be > 0\n");
  EXPECT_FALSE(readVehicle(file).value.has_value());
}

TEST_F(TrainFolder, ContradictionsBetweenATrainAndItsVehiclesAreTold) {
  const std::string file = train(R"(<vehicle file="v.xml" count="2" spacing="20 m"/>)");
  EXPECT_EQ(readTrain(file).problems.text(),
            file +
                ":2: error: <train><vehicle>: the ends of \"v.xml\" and \"v.xml\" overlap by "
                "5 m; take a larger spacing or a smaller end_x\n");
}

TEST(ScenarioReader, NamesPartsOfATrainByVehicleAndPart) {
  const std::string rig = withLine(
      test::kRigLines, 4,
      R"(<input wheelset="coach_2.axle"><sine amplitude="6 mm" angular_frequency="5 rad/s"/></input>)");
  const Scenario scenario = readScenarioText(rig, "s.xml").orThrow();
  EXPECT_EQ(scenario.rig->inputs[0].wheelset, "coach_2.axle");
  EXPECT_EQ(readScenarioText(write(scenario), "s.xml").orThrow(), scenario);
  for (const char* wrong : {"coach_2.", ".axle", "a.b.c", "coach 2.axle"}) {
    const std::string line = std::string("<input wheelset=\"") + wrong +
                             "\"><sine amplitude=\"6 mm\" angular_frequency=\"5 rad/s\"/></input>";
    EXPECT_EQ(readScenarioText(withLine(test::kRigLines, 4, line), "s.xml").problems.text(),
              std::string("s.xml:4: error: <scenario><rig><input>: wheelset=\"") + wrong +
                  "\" is no name; names have up to 64 letters a-z, A-Z, digits, \"_\" and \"-\", and begin with a "
                  "letter or digit\n");
  }
}

// In a file of its own a vehicle's parts have no other vehicle's name before theirs.
TEST(VehicleReader, KnowsNoDotInNames) {
  EXPECT_FALSE(readVehicleText(withLine(test::kVehicleLines, 3, R"(<body name="a.b" mass="9 t" motion="z"/>)"), "v.xml")
                   .value.has_value());
}

}  // namespace
}  // namespace vehicle
