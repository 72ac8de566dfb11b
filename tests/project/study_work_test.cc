#include "libvehicle/project/study_work.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/study/runner.h"
#include "tests/project/files.h"

namespace vehicle {
namespace {

/// A study in a folder of its own, of a train whose vehicle lies in another, with a list of designs.
std::string trainStudyIn(const test::ProjectFolder& folder) {
  folder.put("trains/t.xml",
             test::withLine(test::kTrainLines, 2, R"(<vehicle file="../vehicles/v.xml" count="2" spacing="26 m"/>)"));
  folder.put("vehicles/v.xml", test::textOf(test::kVehicleLines));
  folder.put("studies/lists/list.csv", "coupling.stiffness_z [kN/m]\n40\n60\n");
  return folder.put("studies/study.xml", R"(<study name="d" format="1">
  <vehicle file="../trains/t.xml"/>
  <scenario file="../s.xml"/>
  <plan kind="list" file="lists/list.csv"/>
  <metric name="v_1.frame.az.rms"/>
</study>
)");
}

std::vector<std::string> namesOf(const std::vector<InputFile>& texts) {
  std::vector<std::string> names;
  for (const InputFile& each : texts) names.push_back(each.name);
  return names;
}

TEST(StudyWork, KeepsEveryFileUnderTheNameThatLeadsToItFromTheStudy) {
  const test::ProjectFolder folder;
  FileSource disk;
  const StudyWork work = readStudyWork(trainStudyIn(folder), disk).orThrow();
  EXPECT_EQ(namesOf(work.texts), (std::vector<std::string>{"study.xml", "../trains/t.xml", "../vehicles/v.xml",
                                                           "../s.xml", "lists/list.csv"}));
  EXPECT_EQ(work.texts[2].text, test::textOf(test::kVehicleLines));
  ASSERT_TRUE(work.train.has_value());
  EXPECT_EQ(work.plan.size(), 3u);
}

TEST(StudyWork, IsRestoredFromWhatADatabaseKeepsAloneWithoutAnyFile) {
  StudyRecord record;
  StudyInputs inputs;
  {
    const test::ProjectFolder folder;
    FileSource disk;
    const StudyWork work = readStudyWork(trainStudyIn(folder), disk).orThrow();
    record.inputs = work.texts;
    inputs = work.inputs;
  }
  const std::set<std::filesystem::path> before(
      std::filesystem::directory_iterator(std::filesystem::temp_directory_path()), {});
  const StudyWork again = restoreStudyWork(record);
  EXPECT_EQ(again.inputs.vehicle, inputs.vehicle);
  EXPECT_EQ(again.inputs.study, inputs.study);
  EXPECT_EQ(again.plan.size(), 3u);
  EXPECT_EQ(again.texts, record.inputs);
  // Nothing was laid out on disk, where it could stay or meet another study's files.
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::temp_directory_path())) {
    EXPECT_TRUE(before.contains(entry.path()) || entry.path().string().find("vehicle-study") == std::string::npos)
        << entry.path();
  }
}

// An absolute name leads to the same text in the database, not to what lies there on another machine.
TEST(StudyWork, FindsAVehicleThatIsNamedAbsolutelyInTheDatabaseToo) {
  const test::ProjectFolder folder;
  const std::string vehicle = folder.path("v.xml");
  const std::string study =
      folder.put("in/study.xml", test::withLine(test::withLines(test::kStudyLines, 3, R"(<scenario file="../s.xml"/>)"),
                                                2, "<vehicle file=\"" + vehicle + "\"/>"));
  FileSource disk;
  StudyRecord record;
  record.inputs = readStudyWork(study, disk).orThrow().texts;
  EXPECT_EQ(namesOf(record.inputs), (std::vector<std::string>{"study.xml", vehicle, "../s.xml"}));
  std::filesystem::remove(vehicle);
  EXPECT_EQ(restoreStudyWork(record).inputs.vehicle.name, "v");
}

TEST(StudyWork, OfADatabaseWithoutFilesIsARunThatFailed) {
  EXPECT_THROW(static_cast<void>(restoreStudyWork({})), RunFailed);
  StudyRecord torn;
  torn.inputs = {{"study.xml", test::textOf(test::kStudyLines)}};
  try {
    static_cast<void>(restoreStudyWork(torn));
    FAIL() << "the vehicle is missing";
  } catch (const InvalidInput& wrong) {
    EXPECT_NE(std::string(wrong.what()).find("file=\"v.xml\": is not among the files that are kept"), std::string::npos)
        << wrong.what();
  }
}

// All files change between the reading of the study and the writing of its record.
TEST(StudyWork, ItsRecordHoldsWhatWasRead) {
  const test::ProjectFolder folder;
  FileSource disk;
  const StudyWork work = readStudyWork(folder.path("study.xml"), disk).orThrow();
  for (const char* name : {"study.xml", "v.xml", "s.xml"}) folder.put(name, "edited");
  const StudyRecord record = recordOf(work.plan, {{}, false, "test", work.texts});
  EXPECT_EQ(record.inputs[0].text, test::textOf(test::kStudyLines));
  EXPECT_EQ(record.inputs[1].text, test::textOf(test::kVehicleLines));
  EXPECT_EQ(record.inputs[2].text, test::textOf(test::kScenarioLines));
}

}  // namespace
}  // namespace vehicle
