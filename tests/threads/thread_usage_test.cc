#include "libvehicle/threads/thread_usage.h"

#include <sched.h>

#include <atomic>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "libvehicle/threads/placement.h"
#include "libvehicle/threads/team.h"
#include "tests/support/affinity.h"
#include "tests/support/watchdog.h"

namespace vehicle {
namespace {

void work(std::chrono::milliseconds duration) {
  const auto end = std::chrono::steady_clock::now() + duration;
  while (std::chrono::steady_clock::now() < end) pauseCore();
}

TEST(ThreadUsage, EveryFigureIsThereOrItIsSaidWhyNot) {
  const ThreadUsage usage = usageOfThisThread();
  EXPECT_GT(usage.wall, 0.0);
  EXPECT_GE(usage.running, 0.0);
  EXPECT_GE(usage.voluntary, 0);
  EXPECT_GE(usage.involuntary, 0);
  const std::size_t lacking = (usage.preempted < 0.0) + (usage.blocked_io < 0.0) + (usage.migrations < 0) + 0u;
  EXPECT_EQ(usage.missing.size(), lacking);
}

TEST(ThreadUsage, SleepingIsNotRunningAndIsAVoluntarySwitch) {
  const ThreadUsage before = usageOfThisThread();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const ThreadUsage usage = between(before, usageOfThisThread());
  EXPECT_GE(usage.wall, 0.020);
  EXPECT_LT(usage.running, 0.5 * usage.wall);  // reading the files is all that ran: tens of microseconds
  EXPECT_GE(usage.voluntary, 1);
}

TEST(ThreadUsage, WorkingIsRunningOrWaitingForACore) {
  // A look reads one figure after the other, and may lose its core between two: the time that holds all looks.
  const auto begin = std::chrono::steady_clock::now();
  const ThreadUsage before = usageOfThisThread();
  work(std::chrono::milliseconds(30));
  const ThreadUsage usage = between(before, usageOfThisThread());
  const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_GT(usage.running, 0.0);
  if (usage.preempted < 0.0) return;
  // The kernel brings its sums up to date at a switch or a tick of 1..10 ms; a hypervisor may take a share too, which
  // is no reason to fail: what can be held is that both together are no more than the time that passed.
  EXPECT_GT(usage.running + usage.preempted, 0.0);
  EXPECT_LT(usage.running + usage.preempted, passed + 0.011);
}

TEST(ThreadUsage, TwoThreadsOnOneCoreTakeTurnsAndTheKernelSaysSo) {
  test::Watchdog watchdog;
  const test::OnlyCore only(allowedCores().front());
  // Each computes until the kernel has taken the core away from it; the watchdog ends a kernel that never says so.
  const TeamReport report = runTeam(2, {}, [](Member&) {
    const ThreadUsage before = usageOfThisThread();
    for (bool has_waited = false; !has_waited;) {
      work(std::chrono::milliseconds(10));
      const ThreadUsage usage = between(before, usageOfThisThread());
      has_waited = usage.involuntary >= 1 && (usage.preempted < 0.0 || usage.preempted > 0.005);
    }
  });
  for (const MemberReport& member : report.members) {
    EXPECT_GE(member.usage.involuntary, 1);
    EXPECT_TRUE(member.usage.preempted < 0.0 || member.usage.preempted > 0.005) << member.usage.preempted;
  }
}

TEST(ThreadUsage, AMoveToAnotherCoreIsAMigration) {
  if (allowedCores().size() < 2 || usageOfThisThread().migrations < 0) return;
  long moved = 0;
  std::thread mover([&] {
    const ThreadUsage before = usageOfThisThread();
    for (int i = 0; i < 6; ++i) {
      const test::OnlyCore only(allowedCores()[static_cast<std::size_t>(i % 2)]);
      sched_yield();
    }
    moved = between(before, usageOfThisThread()).migrations;
  });
  mover.join();
  EXPECT_GE(moved, 5);
}

TEST(ThreadUsage, WhatEitherLookLacksIsNotSubtracted) {
  ThreadUsage begin;
  ThreadUsage end;
  begin.wall = 1.0;
  end.wall = 3.0;
  end.running = 2.0;
  end.missing = {"migrations: hidden"};
  const ThreadUsage used = between(begin, end);
  EXPECT_EQ(used.wall, 2.0);
  EXPECT_EQ(used.running, -1.0);
  EXPECT_EQ(used.migrations, -1);
  EXPECT_EQ(used.missing, end.missing);
}

}  // namespace
}  // namespace vehicle
