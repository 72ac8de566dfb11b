#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/xml/reader.h"
#include "libvehicle/xml/writer.h"
#include "tests/support/source_tree.h"
#include "tests/xml/files.h"

namespace vehicle {
namespace {

std::vector<std::string> shippedFiles() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::sourcePath("models"))) {
    if (entry.path().extension() == ".xml") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// True if xmllint holds the files valid by the shipped schema.
bool isValid(const std::string& files) {
  const std::string command =
      "xmllint --noout --nonet --schema '" + test::sourcePath("models/vehicle.xsd") + "' " + files + " >/dev/null 2>&1";
  const int status = std::system(command.c_str());
  // 3: not valid. Anything else (no xmllint, a schema that does not compile) is a failure of the test itself.
  EXPECT_TRUE(WIFEXITED(status) && (WEXITSTATUS(status) == 0 || WEXITSTATUS(status) == 3)) << command << " " << status;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(ShippedModels, ComeBackEqualFromTheWriter) {
  EXPECT_GE(shippedFiles().size(), 15u);
  for (const std::string& file : shippedFiles()) {
    SCOPED_TRACE(file);
    switch (kindOf(file).orThrow()) {
      case FileKind::kVehicle: {
        const Vehicle read = readVehicle(file).orThrow();
        EXPECT_EQ(readVehicleText(write(read), "again.xml").orThrow(), read);
        break;
      }
      case FileKind::kTrain: {
        Train read = readTrain(file).orThrow();
        for (TrainVehicle& each : read.vehicles) each.vehicle = Vehicle();  // what a train's text does not hold
        EXPECT_EQ(readTrainText(write(read), "again.xml").orThrow(), read);
        break;
      }
      case FileKind::kScenario: {
        const Scenario read = readScenario(file).orThrow();
        EXPECT_EQ(readScenarioText(write(read), "again.xml").orThrow(), read);
        break;
      }
      case FileKind::kSuite: {
        const Suite read = readSuite(file).orThrow();
        EXPECT_EQ(readSuiteText(write(read), "again.xml").orThrow(), read);
        break;
      }
      case FileKind::kStudy: {
        const Study read = readStudy(file).orThrow();
        EXPECT_EQ(readStudyText(write(read), "again.xml").orThrow(), read);
        break;
      }
    }
  }
}

TEST(ShippedModels, AreValidByTheShippedSchema) {
  std::string files;
  for (const std::string& file : shippedFiles()) files += " '" + file + "'";
  EXPECT_TRUE(isValid(files));
}

// An XSD that accepts everything would pass the test above.
TEST(ShippedSchema, RefusesWhatTheReaderRefuses) {
  struct Wrong {
    const test::Lines& lines;
    int line;
    const char* instead;
  };
  const std::vector<Wrong> cases = {
      {test::kVehicleLines, 3, R"(<body name="frame" mas="9 t" motion="z"/>)"},
      {test::kVehicleLines, 3, R"(<body name="frame" motion="z"/>)"},
      {test::kVehicleLines, 3, R"(<body name="frame" mass="9" motion="z"/>)"},
      {test::kVehicleLines, 3, R"(<body name="frame" mass="-9 t" motion="z"/>)"},
      {test::kVehicleLines, 3, R"(<body name="frame" mass="9 t" motion="z up"/>)"},
      {test::kVehicleLines, 3, R"(<body name="frame" mass="9 t" motion=""/>)"},
      {test::kVehicleLines, 3, R"(<bodi name="frame" mass="9 t" motion="z"/>)"},
      {test::kVehicleLines, 3, R"(<body name="the frame" mass="9 t" motion="z"/>)"},
      {test::kVehicleLines, 3, R"(<group name="g"><group name="h"/></group>)"},
      {test::kVehicleLines, 1, R"(<vehicle name="v" format="2">)"},
      {test::kScenarioLines, 2, ""},
      {test::kScenarioLines, 3, R"(<track>)"},
      {test::kScenarioLines, 3, R"(<track history="never">)"},
      {test::kScenarioLines, 2, R"(<run speed="20 m/s" duration="10 s"/><run speed="20 m/s" duration="10 s"/>)"},
      {test::kTrainLines, 2, R"(<vehicle file="v.xml" count="0" spacing="26 m"/>)"},
      {test::kTrainLines, 2, R"(<vehicle file="v.xml"/>)"},
      {test::kTrainLines, 3, R"(<coupling stifness_z="50 kN/m"/>)"},
      {test::kRigLines, 4, R"(<input wheelset="a.b.c"><sine amplitude="6 mm" angular_frequency="5 rad/s"/></input>)"},
      {test::kSuiteLines, 4, R"(<speed from="20 km/h" to="150 km/h" count="0"/>)"},
      {test::kStudyLines, 4, R"(<vary from="1 kN/m" to="2 kN/m" count="3"/>)"},
      {test::kStudyLines, 5, R"(<plan kind="random"/>)"},
      {test::kStudyLines, 6, R"(<metric name=" "/>)"},
  };
  const std::string file = (std::filesystem::path(::testing::TempDir()) / "vehicle_wrong.xml").string();
  for (const test::Lines* right : {&test::kVehicleLines, &test::kScenarioLines, &test::kRigLines, &test::kTrainLines,
                                   &test::kSuiteLines, &test::kStudyLines}) {
    std::ofstream(file) << test::textOf(*right);
    EXPECT_TRUE(isValid(file));
  }
  for (const Wrong& each : cases) {
    std::ofstream(file) << test::withLine(each.lines, each.line, each.instead);
    EXPECT_FALSE(isValid(file)) << each.instead;
  }
}

}  // namespace
}  // namespace vehicle
