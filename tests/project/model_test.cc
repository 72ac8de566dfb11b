#include "libvehicle/project/model.h"

#include <gtest/gtest.h>

#include "libvehicle/xml/reader.h"
#include "tests/project/files.h"

namespace vehicle {
namespace {

TEST(Model, KeepsTheTextsThatItWasReadFrom) {
  const test::ProjectFolder folder;
  FileSource disk;
  const Model model = readModel(folder.path("v.xml"), folder.path("s.xml"), disk);
  ASSERT_EQ(model.inputs.size(), 2u);
  EXPECT_EQ(model.inputs[0].name, folder.path("v.xml"));
  EXPECT_EQ(model.inputs[0].text, test::textOf(test::kVehicleLines));
  EXPECT_EQ(model.inputs[1].name, folder.path("s.xml"));
  EXPECT_EQ(model.inputs[1].text, test::textOf(test::kScenarioLines));
}

TEST(Model, OfATrainKeepsTheFilesOfItsVehiclesOnce) {
  const test::ProjectFolder folder;
  FileSource disk;
  const Model model = readModel(folder.path("t.xml"), folder.path("s.xml"), disk);
  ASSERT_EQ(model.inputs.size(), 3u);
  EXPECT_EQ(model.inputs[2].name, folder.path("v.xml"));
}

// The file is edited after the reading and before the texts are taken, as it may be during a long run.
TEST(Model, KeepsWhatWasReadNotWhatTheFileHasBecome) {
  const test::ProjectFolder folder;
  FileSource disk;
  ASSERT_TRUE(readVehicle(folder.path("v.xml"), disk).ok());
  folder.put("v.xml", test::withLine(test::kVehicleLines, 3, R"(<body name="frame" mass="5 t" motion="z"/>)"));
  const Model model = readModel(folder.path("v.xml"), folder.path("s.xml"), disk);
  EXPECT_EQ(model.vehicle.vehicle.bodies[0].mass, 9e3);
  EXPECT_EQ(model.inputs[0].text, test::textOf(test::kVehicleLines));
}

TEST(Model, ProblemsOfBothFilesComeTogether) {
  const test::ProjectFolder folder;
  folder.put("v.xml", test::withLine(test::kVehicleLines, 3, R"(<body name="frame" mass="-1 t" motion="z"/>)"));
  folder.put("s.xml", test::withLine(test::kScenarioLines, 4, R"(<harmonic wavelength="0 m" amplitude="5 mm"/>)"));
  FileSource disk;
  try {
    static_cast<void>(readModel(folder.path("v.xml"), folder.path("s.xml"), disk));
    FAIL() << "both files are wrong";
  } catch (const InvalidInput& wrong) {
    EXPECT_EQ(wrong.problems().size(), 2u) << wrong.what();
  }
}

}  // namespace
}  // namespace vehicle
