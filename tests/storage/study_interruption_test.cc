#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <random>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/storage/study_database.h"
#include "tests/storage/studies.h"
#include "tests/support/test_folder.h"

namespace vehicle {
namespace {

using test::batchOf;
using test::smallStudy;
using test::TestFolder;
using test::textOf;

constexpr std::uint64_t kBatch = 10;

/// Evaluates what is missing, a batch at a time, each beginning at a multiple of kBatch.
void goOn(StudyDatabase& database) {
  for (const DesignRange& range : database.missing()) {
    for (std::uint64_t first = range.first; first <= range.last; first += kBatch) {
      database.append(batchOf(database.record(), first, std::min(first + kBatch, range.last + 1)));
    }
  }
}

std::string csvOf(const std::string& path, const TestFolder& folder) {
  StudyDatabase::read(path).writeCsv(folder.path("table.csv"));
  return textOf(folder.path("table.csv"));
}

// The moments are spread over the time that an uninterrupted run takes: creation, appends, moves of the log. How long
// that is changes with what else the machine does, so a child that came to its end halves the time for those after it.
TEST(StudyDatabaseKilled, AtAnyMomentItReopensWithWholeBatchesAndResumingGivesTheTableOfAnUninterruptedRun) {
  const TestFolder folder;
  const StudyRecord record = smallStudy(10'000);
  const std::string whole = folder.path("whole.sqlite");
  const auto begin = std::chrono::steady_clock::now();
  {
    StudyDatabase database = StudyDatabase::create(whole, record);
    goOn(database);
  }
  const std::chrono::duration<double, std::micro> duration = std::chrono::steady_clock::now() - begin;
  const std::string truth = csvOf(whole, folder);
  std::mt19937 random(4);
  double longest = 0.7 * duration.count();
  constexpr int kKills = 20;
  int interrupted = 0;
  for (int kill = 0; interrupted < kKills && kill < 10 * kKills; ++kill) {
    const std::string path = folder.path(std::string("killed").append(std::to_string(kill)));
    const pid_t child = ::fork();
    if (child == 0) {
      StudyDatabase database = StudyDatabase::create(path, record);
      goOn(database);
      ::_exit(0);
    }
    const double moment = std::uniform_real_distribution<>(0.0, longest)(random);
    std::this_thread::sleep_for(std::chrono::duration<double, std::micro>(moment));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) {
      ++interrupted;
    } else {
      longest *= 0.5;
    }
    if (!std::filesystem::exists(path)) {
      static_cast<void>(StudyDatabase::create(path, record));
    }
    StudyDatabase database = StudyDatabase::resume(path, record);
    EXPECT_EQ(database.stored() % kBatch, 0u);
    for (const DesignRange& range : database.missing()) EXPECT_EQ(range.first % kBatch, 0u);
    goOn(database);
    EXPECT_EQ(csvOf(path, folder), truth) << "kill " << kill;
  }
  EXPECT_EQ(interrupted, kKills);
}

/// The largest file this process may write, as a disk that is full would have it.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

TEST(StudyDatabaseOnAFullDisk, NothingStoredIsLostAndItGoesOnWhereThereIsRoomAgain) {
  const TestFolder folder;
  const StudyRecord record = smallStudy(20'000);
  const std::string path = folder.path("study.sqlite");
  std::uint64_t safe = 0;
  {
    StudyDatabase database = StudyDatabase::create(path, record);
    std::string said;
    {
      const FileSizeLimit limit(400'000);
      try {
        for (; safe < record.designs; safe += kBatch) database.append(batchOf(record, safe, safe + kBatch));
      } catch (const RunFailed& error) {
        said = error.what();
      }
    }
    EXPECT_TRUE(said.starts_with(path + ": cannot be written: ")) << said;
    EXPECT_TRUE(said.ends_with("; what was stored before is safe; make room and go on with it")) << said;
    EXPECT_GT(safe, 0u);
    EXPECT_EQ(database.stored(), safe);
    // The same object goes on as soon as there is room.
    database.append(batchOf(record, safe, safe + kBatch));
    EXPECT_EQ(database.stored(), safe + kBatch);
  }
  StudyDatabase database = StudyDatabase::resume(path, record);
  EXPECT_EQ(database.missing(), (std::vector<DesignRange>{{safe + kBatch, record.designs - 1}}));
  goOn(database);
  EXPECT_TRUE(database.missing().empty());
}

TEST(StudyDatabaseOnAFullDisk, ANewStudyIsRefusedAndLeavesNoFile) {
  const TestFolder folder;
  {
    const FileSizeLimit limit(10'000);
    EXPECT_THROW(StudyDatabase::create(folder.path("study.sqlite"), smallStudy()), RunFailed);
  }
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(StudyDatabaseDamaged, ItIsNotGoneOnWithAndLeftAsItIs) {
  const TestFolder folder;
  const StudyRecord record = smallStudy(10'000);
  const std::string path = folder.path("study.sqlite");
  {
    StudyDatabase database = StudyDatabase::create(path, record);
    database.append(batchOf(record, 0, 6'000));
  }
  const std::string whole = textOf(path);
  constexpr std::size_t kPage = 16384;
  int refused = 0;
  int pages = 0;
  // The cell count of a page: nothing that opening reads, except in the first pages.
  for (std::size_t page = 4; (page + 1) * kPage <= whole.size(); page += 5, ++pages) {
    std::string damaged = whole;
    damaged[page * kPage + 3] = '\x7f';
    static_cast<void>(folder.file("study.sqlite", damaged));
    try {
      static_cast<void>(StudyDatabase::resume(path, record));
    } catch (const InvalidInput& failure) {
      EXPECT_NE(std::string(failure.what()).find("is damaged ("), std::string::npos) << failure.what();
      ++refused;
    }
    EXPECT_TRUE(textOf(path) == damaged) << page;
  }
  EXPECT_GE(pages, 5);
  EXPECT_EQ(refused, pages);
}

}  // namespace
}  // namespace vehicle
