#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/storage/csv_text.h"
#include "libvehicle/storage/study_database.h"
#include "tests/storage/studies.h"
#include "tests/support/test_folder.h"

// A study as comma-separated text.
namespace vehicle {
namespace {

using test::batchOf;
using test::hasFailed;
using test::metricsOfDesign;
using test::parametersOfDesign;
using test::smallStudy;
using test::TestFolder;
using test::textOf;

TEST(StudyCsv, NamesTheDesignsWhereNamesAreGiven) {
  const TestFolder folder;
  const StudyRecord record = smallStudy(2);
  StudyDatabase database = StudyDatabase::create(folder.path("study.sqlite"), record);
  database.append(batchOf(record, 0, 2));
  database.writeCsv(folder.path("study.csv"), [](std::uint64_t id) { return id == 0 ? "base" : "soft, \"1\""; });
  const std::string text = textOf(folder.path("study.csv"));
  std::string_view rest = text;
  EXPECT_TRUE(takeLine(rest).starts_with("id,design,status,carbody.mass [kg],"));
  for (const char* name : {"base", "soft, \"1\""}) {
    const auto fields = splitFields(takeLine(rest)).value();
    ASSERT_EQ(fields.size(), 10u);
    EXPECT_EQ(fields[1], name);
  }
}

TEST(StudyCsv, HoldsEveryDesignWithNumbersThatReadBack) {
  const TestFolder folder;
  const StudyRecord record = smallStudy(5);
  StudyDatabase database = StudyDatabase::create(folder.path("study.sqlite"), record);
  database.append(batchOf(record, 0, 5));
  database.writeCsv(folder.path("study.csv"));
  const std::string text = textOf(folder.path("study.csv"));
  std::string_view rest = text;
  EXPECT_EQ(takeLine(rest),
            "id,status,carbody.mass [kg],primary.stiffness_z [N/m],carbody.az.rms @ 80 km/h [m/s^2],"
            "carbody.az.rms @ 120 km/h [m/s^2],\"static, load [N]\",warnings,message");
  for (std::uint64_t id = 0; id < 5; ++id) {
    const auto fields = splitFields(takeLine(rest)).value();
    ASSERT_EQ(fields.size(), 9u);
    EXPECT_EQ(fields[0], std::to_string(id));
    EXPECT_EQ(std::stod(fields[3]), parametersOfDesign(id)[1]);
    EXPECT_EQ(fields[4].empty(), hasFailed(id));
    if (!hasFailed(id)) {
      EXPECT_EQ(std::stod(fields[6]), metricsOfDesign(id)[2]);
    }
    EXPECT_EQ(fields[8], hasFailed(id) ? "no steady state at 80 km/h, \"3\"" : "");
  }
  EXPECT_TRUE(rest.empty());
}

// A design without warnings has no word there, in the file and in the table of SQLite.
TEST(StudyCsv, WarningsOfADesignAreWordsInAColumn) {
  const TestFolder folder;
  const StudyRecord record = smallStudy(2);
  StudyDatabase database = StudyDatabase::create(folder.path("study.sqlite"), record);
  WarningSet warnings;
  warnings.insert(WarningCode::kLargeMotion);
  warnings.insert(WarningCode::kWheelLoad);
  DesignBatch batch(2, 3);
  batch.add(0, parametersOfDesign(0), metricsOfDesign(0), {}, warnings);
  batch.add(1, parametersOfDesign(1), metricsOfDesign(1));
  database.append(batch);
  std::vector<WarningSet> read;
  StudyDatabase::read(folder.path("study.sqlite")).forEach([&](const StoredDesign& design) {
    read.push_back(design.warnings);
    return true;
  });
  EXPECT_EQ(read, (std::vector<WarningSet>{warnings, {}}));
  database.writeCsv(folder.path("study.csv"));
  const std::string text = textOf(folder.path("study.csv"));
  std::string_view rest = text;
  static_cast<void>(takeLine(rest));
  EXPECT_EQ(splitFields(takeLine(rest)).value()[7], "WHEEL_LOAD LARGE_MOTION");
  EXPECT_EQ(splitFields(takeLine(rest)).value()[7], "");
}

}  // namespace
}  // namespace vehicle
