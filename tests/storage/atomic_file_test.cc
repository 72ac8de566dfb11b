#include "libvehicle/storage/atomic_file.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

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
#include "tests/storage/scratch.h"

namespace vehicle {
namespace {

using test::contentOf;
using test::numberedHistory;
using test::put;
using test::Scratch;

std::string failureOf(const std::function<void()>& write) {
  try {
    write();
  } catch (const RunFailed& error) {
    return error.what();
  }
  return "written";
}

TEST(AtomicFile, NothingStandsUnderTheNameBeforeItIsPublished) {
  const Scratch scratch;
  put(scratch / "run.csv", "old");
  {
    AtomicFile file(scratch / "run.csv");
    file.write("new");
    EXPECT_EQ(contentOf(scratch / "run.csv"), "old");
    file.publish();
    EXPECT_EQ(contentOf(scratch / "run.csv"), "new");
  }
  EXPECT_EQ(scratch.entries(), 1u);
}

TEST(AtomicFile, WhatIsNotPublishedLeavesNoTrace) {
  const Scratch scratch;
  { AtomicFile(scratch / "run.csv").write("half"); }
  EXPECT_EQ(scratch.entries(), 0u);
}

TEST(AtomicFile, TwoWritersOfOneNameDoNotMeet) {
  const Scratch scratch;
  AtomicFile first(scratch / "run.csv");
  AtomicFile second(scratch / "run.csv");
  first.write("first");
  second.write("second");
  second.publish();
  first.publish();
  EXPECT_EQ(contentOf(scratch / "run.csv"), "first");
}

TEST(AtomicFile, ALinkStaysALink) {
  const Scratch scratch;
  put(scratch / "target.csv", "old");
  std::filesystem::create_symlink(scratch / "target.csv", scratch / "link.csv");
  AtomicFile file(scratch / "link.csv");
  file.write("new");
  file.publish();
  EXPECT_TRUE(std::filesystem::is_symlink(scratch / "link.csv"));
  EXPECT_EQ(contentOf(scratch / "target.csv"), "new");
}

TEST(AtomicFile, PermissionsFollowTheUmask) {
  const Scratch scratch;
  const mode_t before = ::umask(027);
  AtomicFile file(scratch / "run.csv");
  file.publish();
  ::umask(before);
  EXPECT_EQ(std::filesystem::status(scratch / "run.csv").permissions(), std::filesystem::perms(0640));
}

TEST(AtomicFile, PlacesThatCannotBeWrittenAreToldWithTheReason) {
  const Scratch scratch;
  const std::string inNoFolder = (scratch / "missing/run.csv").string();
  EXPECT_EQ(failureOf([&] { AtomicFile file(inNoFolder); }),
            inNoFolder + ": cannot be written: No such file or directory; its folder must exist and be writable");
  put(scratch / "file", "");
  const std::string inAFile = (scratch / "file/run.csv").string();
  EXPECT_EQ(failureOf([&] { AtomicFile file(inAFile); }),
            inAFile + ": cannot be written: Not a directory; its folder must exist and be writable");
  std::filesystem::create_directory(scratch / "folder.csv");
  const std::string folder = (scratch / "folder.csv").string();
  EXPECT_EQ(failureOf([&] { AtomicFile file(folder); }),
            folder + ": cannot be written: Is a directory; name a file in it");
  EXPECT_EQ(failureOf([] { AtomicFile file("/dev/full"); }),
            "/dev/full: cannot be written: it is a device or pipe; name a regular file");
  const std::string tooLong = (scratch / (std::string(300, 'x') + ".csv")).string();
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
    const Scratch scratch;
    put(scratch / name, "old");
    const std::string path = (scratch / name).string();
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
    EXPECT_EQ(contentOf(path), "old");
    EXPECT_EQ(scratch.entries(), 1u);
  }
}

// Root may write anywhere: the child gives its rights up first where it has them.
TEST(AtomicFile, AFileOrFolderWithoutPermissionIsLeftAlone) {
  const Scratch scratch;
  const std::filesystem::path folder = scratch / "locked";
  std::filesystem::create_directory(folder);
  put(folder / "old.csv", "old");
  put(scratch / "readonly.csv", "old");
  using std::filesystem::perms;
  std::filesystem::permissions(scratch / "readonly.csv", perms(0444));
  std::filesystem::permissions(folder, perms(0555));
  std::filesystem::permissions(scratch / "", perms(0777));
  const int status = inAChild([&] {
    constexpr uid_t kNobody = 65534;
    if (::geteuid() == 0 && ::setuid(kNobody) != 0) ::_exit(1);
    const auto ends = [](const std::string& text, const char* end) { return text.find(end) != std::string::npos; };
    if (!ends(failureOf([&] { AtomicFile file(folder / "old.csv"); }), "Permission denied")) ::_exit(2);
    if (!ends(failureOf([&] { AtomicFile file(scratch / "readonly.csv"); }), "cannot be replaced: Permission denied")) {
      ::_exit(3);
    }
    ::_exit(7);
  });
  std::filesystem::permissions(folder, perms(0755));
  EXPECT_EQ(status, 7) << "1 rights could not be dropped, 2 the folder, 3 the file";
  EXPECT_EQ(contentOf(folder / "old.csv"), "old");
}

// A child writes version after version over the same name and is killed at a random moment, wherever that falls:
// composing, writing, flushing, renaming. What stands there must be one whole version.
void killWhileWriting(const std::string& name, const std::function<TimeHistory(const std::string&)>& read) {
  const Scratch scratch;
  const std::string path = (scratch / name).string();
  constexpr int kSamples = 20000;
  writeHistory(path, {numberedHistory(0, kSamples), {}, {}});
  std::mt19937 random(7);
  std::uniform_int_distribution<int> microseconds(0, 30000);
  int versions = 0;
  for (int round = 0; round < 25; ++round) {
    const pid_t child = ::fork();
    if (child == 0) {
      for (int version = 1;; ++version) writeHistory(path, {numberedHistory(version, kSamples), {}, {}});
    }
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds(random)));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const TimeHistory history = read(path);
    ASSERT_EQ(history.samples(), static_cast<std::size_t>(kSamples)) << "round " << round;
    const double version = history.at(0, 1);
    for (std::size_t i = 0; i < history.samples(); ++i) ASSERT_EQ(history.at(i, 1), version) << "round " << round;
    versions += version > 0.0 ? 1 : 0;
  }
  // The kills must fall among writes, or this test shows nothing.
  EXPECT_GT(versions, 0);
}

TEST(AtomicFile, AKilledRunLeavesAWholeCsv) {
  killWhileWriting("run.csv", [](const std::string& path) { return readCsv(path).orThrow(); });
}

TEST(AtomicFile, AKilledRunLeavesAWholeHdf5) {
  killWhileWriting("run.h5", [](const std::string& path) { return readHdf5(path).orThrow().history; });
}

}  // namespace
}  // namespace vehicle
