#include "libvehicle/xml/file_source.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "libvehicle/xml/reader.h"
#include "tests/support/test_folder.h"
#include "tests/xml/files.h"

namespace vehicle {
namespace {

TEST(FileSource, GivesTheTextOfTheFirstReadingWhateverHappensToTheFile) {
  const test::TestFolder folder;
  const std::string path = folder.file("a.xml", "first");
  FileSource files;
  EXPECT_EQ(files.text(path).value, "first");
  folder.file("a.xml", "second");
  EXPECT_EQ(files.text(path).value, "first");
  std::filesystem::remove(path);
  EXPECT_EQ(files.text(path).value, "first");
  EXPECT_EQ(FileSource().text(path).value, std::nullopt);
}

TEST(FileSource, KnowsAFileByItsPlaceHoweverThatIsSpelt) {
  const test::TestFolder folder;
  folder.file("a.xml", "first");
  FileSource files;
  EXPECT_EQ(files.text(folder.path("a.xml")).value, "first");
  folder.file("a.xml", "second");
  EXPECT_EQ(files.text(folder.path("b/../a.xml")).value, "first");
  EXPECT_EQ(files.text(std::filesystem::relative(folder.path("a.xml")).string()).value, "first");
}

TEST(FileSource, AFileThatWasNotThereStaysSo) {
  const test::TestFolder folder;
  FileSource files;
  EXPECT_EQ(files.text(folder.path("a.xml")).problems.size(), 1u);
  folder.file("a.xml", "late");
  EXPECT_FALSE(files.text(folder.path("a.xml")).value);
}

TEST(FileSource, OfTextsReadsNothingFromDisk) {
  const test::TestFolder folder;
  const std::string on_disk = folder.file("a.xml", "on disk");
  FileSource kept({{"study.xml", "a study"}, {"../vehicles/coach.xml", "a vehicle"}});
  EXPECT_EQ(kept.text("study.xml").value, "a study");
  EXPECT_EQ(kept.text("in/../../vehicles/coach.xml").value, "a vehicle");
  EXPECT_EQ(kept.text(on_disk).problems.text(),
            on_disk + ": error: is not among the files that are kept; read the files from disk again\n");
}

TEST(FileSource, ServesTheReadersOfEveryKind) {
  const test::TestFolder folder;
  const std::string train = folder.file("t.xml", test::textOf(test::kTrainLines));
  const std::string vehicle = folder.file("v.xml", test::textOf(test::kVehicleLines));
  FileSource files;
  const Vehicle first = readVehicle(train, files).orThrow();
  folder.file("v.xml", test::withLine(test::kVehicleLines, 3, R"(<body name="frame" mass="5 t" motion="z"/>)"));
  EXPECT_EQ(readVehicle(train, files).orThrow(), first);
  EXPECT_EQ(readVehicle(vehicle, files).orThrow().bodies[0].mass, 9e3);
  EXPECT_EQ(readVehicle(vehicle).orThrow().bodies[0].mass, 5e3);
}

}  // namespace
}  // namespace vehicle
