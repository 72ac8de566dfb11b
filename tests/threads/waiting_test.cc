#include "libvehicle/threads/waiting.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace vehicle {
namespace {

std::string refusalOf(const std::string& name, int threads, int cores) {
  try {
    (void)waitingFor(waitingKindOf(name), threads, cores);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Waiting, SpinIsRefusedWhereThreadsExceedCores) {
  EXPECT_EQ(refusalOf("spin", 2, 2), "accepted");
  EXPECT_EQ(refusalOf("spin", 3, 2),
            "waiting \"spin\": 3 threads on 2 cores would keep each other from running; take at most 2, or "
            "auto | yield | sleep");
  EXPECT_EQ(refusalOf("spin", 2, 1),
            "waiting \"spin\": 2 threads on 1 core would keep each other from running; take at most 1, or "
            "auto | yield | sleep");
  for (const char* name : {"auto", "yield", "sleep"}) EXPECT_EQ(refusalOf(name, 64, 1), "accepted") << name;
}

TEST(Waiting, AnUnknownNameAndSenselessCountsAreRefused) {
  EXPECT_EQ(refusalOf("futex", 2, 2), "unknown waiting \"futex\"; must be auto | spin | yield | sleep");
  EXPECT_EQ(refusalOf("auto", 0, 2), "waiting: threads = 0, must be >= 1");
  EXPECT_EQ(refusalOf("auto", 2, 0), "waiting: cores = 0, must be >= 1");
}

TEST(Waiting, ThreadsThatTakeTurnsGiveTheCoreAwaySooner) {
  EXPECT_LT(waitingFor(WaitingKind::kAuto, 3, 2).pauses, waitingFor(WaitingKind::kAuto, 2, 2).pauses);
}

// A real-time thread that never sleeps would keep everybody else off its core.
TEST(Waiting, OnlyPoliciesThatSleepInTheEndGiveWay) {
  EXPECT_TRUE(givesWay(waitingFor(WaitingKind::kAuto, 2, 2)));
  EXPECT_TRUE(givesWay(waitingFor(WaitingKind::kAuto, 4, 2)));
  EXPECT_TRUE(givesWay(waitingFor(WaitingKind::kSleep, 2, 2)));
  EXPECT_FALSE(givesWay(waitingFor(WaitingKind::kSpin, 2, 2)));
  EXPECT_FALSE(givesWay(waitingFor(WaitingKind::kYield, 2, 2)));
}

TEST(Waiting, NamesLeadBackToTheirKind) {
  for (const std::string& name : waitingNames()) EXPECT_EQ(nameOf(waitingKindOf(name)), name);
}

TEST(Waiting, BlocksAfterItsPausesAndYields) {
  YieldMemory memory;
  const Waiting waiting{.pauses = 3, .yields = 0, .sleep = 1e-6};
  Patience patience(waiting, memory);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(patience.turn());
  EXPECT_FALSE(patience.turn());
  Patience wanted(waiting, memory);
  EXPECT_FALSE(wanted.turn(true)) << "no pause where the core is wanted";
  const Waiting forever{.pauses = Waiting::kForever, .yields = 0, .sleep = 0.0};
  Patience endless(forever, memory);
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(endless.turn());
}

}  // namespace
}  // namespace vehicle
