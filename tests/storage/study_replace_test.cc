// A study's database in the place of another file, under names that SQLite would read otherwise.
#include <filesystem>
#include <functional>
#include <string>

#include <gtest/gtest.h>
#include <sqlite3.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/storage/study_database.h"
#include "tests/storage/studies.h"
#include "tests/support/test_folder.h"

namespace vehicle {
namespace {

using test::batchOf;
using test::refusalOf;
using test::smallStudy;
using test::TestFolder;

/// Another program with a transaction open.
class SqliteWriter {
 public:
  explicit SqliteWriter(const std::string& path) {
    EXPECT_EQ(sqlite3_open(path.c_str(), &handle_), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(handle_, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr), SQLITE_OK);
  }
  ~SqliteWriter() { sqlite3_close(handle_); }
  SqliteWriter(const SqliteWriter&) = delete;
  SqliteWriter& operator=(const SqliteWriter&) = delete;

 private:
  sqlite3* handle_ = nullptr;
};

TEST(StudyDatabase, AnEmptyFileIsTakenForANewOneAndALinkIsFollowed) {
  const TestFolder folder;
  const std::string path = folder.file("empty.sqlite", "");
  std::filesystem::create_symlink("other.sqlite", folder.path("link.sqlite"));
  for (const std::string& each : {path, folder.path("link.sqlite")}) {
    EXPECT_EQ(StudyDatabase::create(each, smallStudy()).stored(), 0u);
    EXPECT_EQ(StudyDatabase::read(each).record(), smallStudy());
  }
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link.sqlite")));
  EXPECT_TRUE(std::filesystem::is_regular_file(folder.path("other.sqlite")));
}

TEST(StudyDatabase, ANameThatSqliteWouldReadAsAUriIsAFileName) {
  const TestFolder folder;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.root());
  for (const char* name : {"file:a.sqlite", "file:b.sqlite?mode=memory", ":memory:"}) {
    EXPECT_EQ(StudyDatabase::create(name, smallStudy()).stored(), 0u);
    EXPECT_TRUE(std::filesystem::is_regular_file(folder.path(name))) << name;
    EXPECT_EQ(StudyDatabase::resume(name, smallStudy()).stored(), 0u) << name;
  }
  std::filesystem::current_path(before);
  EXPECT_EQ(folder.entries(), 3u);
}

TEST(StudyDatabase, IsReplacedWholeOnlyWhereNobodyWritesIt) {
  const TestFolder folder;
  const std::string path = folder.path("study.sqlite");
  StudyRecord other = smallStudy(3);
  other.metrics.pop_back();
  {
    StudyDatabase database = StudyDatabase::create(path, smallStudy());
    database.append(batchOf(database.record(), 0, 10));
    EXPECT_EQ(refusalOf(folder, [&] { static_cast<void>(StudyDatabase::replace(path, other)); }),
              "study.sqlite: another process is writing it; wait for its end");
  }
  {
    // Any SQLite tool may be writing, without our lock.
    SqliteWriter tool(path);
    EXPECT_EQ(refusalOf(folder, [&] { static_cast<void>(StudyDatabase::replace(path, other)); }),
              "study.sqlite: another process is writing it; wait for its end");
  }
  EXPECT_EQ(StudyDatabase::read(path).stored(), 10u);
  EXPECT_EQ(StudyDatabase::replace(path, other).stored(), 0u);
  EXPECT_EQ(StudyDatabase::read(path).record(), other);
  const std::string foreign = folder.file("foreign.sqlite", "SQLite format 3");
  EXPECT_EQ(refusalOf(folder, [&] { static_cast<void>(StudyDatabase::replace(foreign, other)); }),
            "foreign.sqlite: exists already; go on with it, remove it, or name another file");
  EXPECT_EQ(folder.entries(), 2u);
}

}  // namespace
}  // namespace vehicle
