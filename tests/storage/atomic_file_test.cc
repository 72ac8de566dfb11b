#include "libvehicle/storage/atomic_file.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/storage/csv.h"
#include "libvehicle/storage/hdf5.h"
#include "libvehicle/storage/history_file.h"
#include "tests/storage/histories.h"
#include "tests/support/test_folder.h"

namespace vehicle {
namespace {

using test::numberedHistory;
using test::TestFolder;
using test::textOf;

std::string failureOf(const std::function<void()>& write) {
  try {
    write();
  } catch (const RunFailed& error) {
    return error.what();
  }
  return "written";
}

TEST(AtomicFile, NothingStandsUnderTheNameBeforeItIsPublished) {
  const TestFolder scratch;
  scratch.file("run.csv", "old");
  {
    AtomicFile file(scratch.path("run.csv"));
    file.write("new");
    EXPECT_EQ(textOf(scratch.path("run.csv")), "old");
    file.publish();
    EXPECT_EQ(textOf(scratch.path("run.csv")), "new");
  }
  EXPECT_EQ(scratch.entries(), 1u);
}

TEST(AtomicFile, WhatIsNotPublishedLeavesNoTrace) {
  const TestFolder scratch;
  { AtomicFile(scratch.path("run.csv")).write("half"); }
  EXPECT_EQ(scratch.entries(), 0u);
}

TEST(AtomicFile, TwoWritersOfOneNameDoNotMeet) {
  const TestFolder scratch;
  AtomicFile first(scratch.path("run.csv"));
  AtomicFile second(scratch.path("run.csv"));
  first.write("first");
  second.write("second");
  second.publish();
  first.publish();
  EXPECT_EQ(textOf(scratch.path("run.csv")), "first");
}

TEST(AtomicFile, ALinkStaysALink) {
  const TestFolder scratch;
  scratch.file("target.csv", "old");
  std::filesystem::create_symlink(scratch.path("target.csv"), scratch.path("link.csv"));
  AtomicFile file(scratch.path("link.csv"));
  file.write("new");
  file.publish();
  EXPECT_TRUE(std::filesystem::is_symlink(scratch.path("link.csv")));
  EXPECT_EQ(textOf(scratch.path("target.csv")), "new");
}

TEST(AtomicFile, PermissionsFollowTheUmask) {
  const TestFolder scratch;
  const mode_t before = ::umask(027);
  AtomicFile file(scratch.path("run.csv"));
  file.publish();
  ::umask(before);
  EXPECT_EQ(std::filesystem::status(scratch.path("run.csv")).permissions(), std::filesystem::perms(0640));
}

TEST(AtomicFile, PlacesThatCannotBeWrittenAreToldWithTheReason) {
  const TestFolder scratch;
  const std::string inNoFolder = scratch.path("missing/run.csv");
  EXPECT_EQ(failureOf([&] { AtomicFile file(inNoFolder); }),
            inNoFolder + ": cannot be written: No such file or directory; its folder must exist and be writable");
  scratch.file("file", "");
  const std::string inAFile = scratch.path("file/run.csv");
  EXPECT_EQ(failureOf([&] { AtomicFile file(inAFile); }),
            inAFile + ": cannot be written: Not a directory; its folder must exist and be writable");
  std::filesystem::create_directory(scratch.path("folder.csv"));
  const std::string folder = scratch.path("folder.csv");
  EXPECT_EQ(failureOf([&] { AtomicFile file(folder); }),
            folder + ": cannot be written: Is a directory; name a file in it");
  EXPECT_EQ(failureOf([] { AtomicFile file("/dev/full"); }),
            "/dev/full: cannot be written: it is a device or pipe; name a regular file");
  const std::string tooLong = scratch.path(std::string(300, 'x') + ".csv");
  EXPECT_EQ(failureOf([&] { AtomicFile file(tooLong); }),
            tooLong + ": cannot be written: File name too long; its folder must exist and be writable");
}

// Runs `write` in a child and gives its exit status: limits, rights and kills then stay away from this process.
int inAChild(const std::function<void()>& write) {
  const pid_t child = ::fork();
  if (child == 0) {
    write();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

// A limit on the size of files stands for a disk that fills while the file is being written.
TEST(AtomicFile, ADiskThatFillsKeepsTheOldFileAndLeavesNoHalfOne) {
  for (const std::string name : {"run.csv", "run.h5"}) {
    const TestFolder scratch;
    scratch.file(name, "old");
    const std::string path = scratch.path(name);
    const std::string expected =
        path + ": cannot be written: File too large; the file that stood there before is unchanged";
    const int status = inAChild([&] {
      ::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{4096, 4096};
      if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(1);
      const std::string failure = failureOf([&] { writeHistory(path, {numberedHistory(1, 100000), {}, {}}); });
      ::_exit(failure == expected ? 7 : 2);
    });
    EXPECT_EQ(status, 7) << name << ": 1 no limit could be set, 2 another message, 0 it was written";
    EXPECT_EQ(textOf(path), "old");
    EXPECT_EQ(scratch.entries(), 1u);
  }
}

// Root may write anywhere: the child gives its rights up first where it has them.
TEST(AtomicFile, AFileOrFolderWithoutPermissionIsLeftAlone) {
  const TestFolder scratch;
  const std::filesystem::path folder = scratch.path("locked");
  std::filesystem::create_directory(folder);
  scratch.file("locked/old.csv", "old");
  scratch.file("readonly.csv", "old");
  using std::filesystem::perms;
  std::filesystem::permissions(scratch.path("readonly.csv"), perms(0444));
  std::filesystem::permissions(folder, perms(0555));
  std::filesystem::permissions(scratch.path(""), perms(0777));
  const int status = inAChild([&] {
    constexpr uid_t kNobody = 65534;
    if (::geteuid() == 0 && ::setuid(kNobody) != 0) ::_exit(1);
    const auto ends = [](const std::string& text, const char* end) { return text.find(end) != std::string::npos; };
    if (!ends(failureOf([&] { AtomicFile file(folder / "old.csv"); }), "Permission denied")) ::_exit(2);
    if (!ends(failureOf([&] { AtomicFile file(scratch.path("readonly.csv")); }),
              "cannot be replaced: Permission denied")) {
      ::_exit(3);
    }
    ::_exit(7);
  });
  std::filesystem::permissions(folder, perms(0755));
  EXPECT_EQ(status, 7) << "1 rights could not be dropped, 2 the folder, 3 the file";
  EXPECT_EQ(textOf(folder / "old.csv"), "old");
}

// A child writes version after version over the same name and is killed at a random moment after the first ones,
// wherever that falls: composing, writing, flushing, renaming. What stands there must be one whole version.
void killWhileWriting(const std::string& name, const std::function<TimeHistory(const std::string&)>& read) {
  const TestFolder scratch;
  const std::string path = scratch.path(name);
  constexpr int kSamples = 20000;
  writeHistory(path, {numberedHistory(0, kSamples), {}, {}});
  std::mt19937 random(7);
  // Of the time that the child took for its first versions: where the kill falls in the next one.
  std::uniform_real_distribution<double> share(0.0, 1.0);
  int versions = 0;
  for (int round = 0; round < 25; ++round) {
    int ends[2] = {-1, -1};  // the child says here that a version is written
    ASSERT_EQ(::pipe(ends), 0);
    const auto begin = std::chrono::steady_clock::now();
    const pid_t child = ::fork();
    if (child == 0) {
      for (int version = 1;; ++version) {
        writeHistory(path, {numberedHistory(version, kSamples), {}, {}});
        if (::write(ends[1], "v", 1) != 1) ::_exit(1);
      }
    }
    ::close(ends[1]);
    char said = 0;
    const int awaited = round % 3;
    for (int i = 0; i < awaited; ++i) ASSERT_EQ(::read(ends[0], &said, 1), 1);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    std::this_thread::sleep_for(share(random) * took / std::max(1, awaited));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(ends[0]);
    const TimeHistory history = read(path);
    ASSERT_EQ(history.samples(), static_cast<std::size_t>(kSamples)) << "round " << round;
    const double version = history.at(0, 1);
    for (std::size_t i = 0; i < history.samples(); ++i) ASSERT_EQ(history.at(i, 1), version) << "round " << round;
    versions += version > 0.0 ? 1 : 0;
  }
  // Two kills of three fall after a version has been written.
  EXPECT_GE(versions, 16);
}

TEST(AtomicFile, AKilledRunLeavesAWholeCsv) {
  killWhileWriting("run.csv", [](const std::string& path) { return readCsv(path).orThrow(); });
}

TEST(AtomicFile, AKilledRunLeavesAWholeHdf5) {
  killWhileWriting("run.h5", [](const std::string& path) { return readHdf5(path).orThrow().history; });
}

}  // namespace
}  // namespace vehicle
