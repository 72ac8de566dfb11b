#include "libvehicle/threads/placement.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "libvehicle/threads/team.h"
#include "tests/support/affinity.h"

namespace vehicle {
namespace {

TEST(Placement, AllowedCoresAreThoseOfTheAffinityMaskEachOnce) {
  const cpu_set_t mask = test::maskOfThisThread();
  std::vector<int> cores = allowedCores();
  EXPECT_EQ(cores.size(), static_cast<std::size_t>(CPU_COUNT(&mask)));
  EXPECT_EQ(allowedCoreCount(), CPU_COUNT(&mask));
  std::ranges::sort(cores);
  EXPECT_EQ(std::ranges::adjacent_find(cores), cores.end());
  for (const int core : cores) EXPECT_TRUE(CPU_ISSET(static_cast<unsigned>(core), &mask)) << core;
}

TEST(Placement, AMaskOfOneCoreIsRespectedByCoresAndPolicy) {
  for (const int core : allowedCores()) {
    const test::OnlyCore only(core);
    EXPECT_EQ(allowedCores(), std::vector<int>{core});
    EXPECT_EQ(allowedCoreCount(), 1);
    const TeamReport report = runTeam(2, {}, [](Member&) {});
    EXPECT_EQ(report.cores, std::vector<int>{core});
    for (const MemberReport& member : report.members) EXPECT_EQ(member.core_after, core);
    EXPECT_EQ(report.waiting.pauses, waitingFor(WaitingKind::kAuto, 2, 1).pauses);
    EXPECT_THROW(runTeam(2, {.waiting = WaitingKind::kSpin}, [](Member&) {}), std::invalid_argument);
  }
}

TEST(Placement, ThreadsStandOnTheirCoresAndTheCallerKeepsItsOwn) {
  const cpu_set_t before = test::maskOfThisThread();
  const std::vector<int> cores = allowedCores();
  const int threads = static_cast<int>(cores.size()) + 1;
  std::vector<int> seen(static_cast<std::size_t>(threads));
  const TeamReport report =
      runTeam(threads, {}, [&](Member& me) { seen[static_cast<std::size_t>(me.number())] = sched_getcpu(); });
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_TRUE(report.members[i].pinned) << report.members[i].pinning_note;
    EXPECT_EQ(seen[i], cores[i % cores.size()]);
    EXPECT_EQ(report.members[i].core_after, seen[i]);
    EXPECT_GE(report.members[i].core_before, 0);
  }
  const cpu_set_t after = test::maskOfThisThread();
  EXPECT_TRUE(CPU_EQUAL(&before, &after));
}

TEST(Placement, AFreeTeamKeepsTheWholeMaskAndSaysThatItWasNotPinned) {
  const cpu_set_t mask = test::maskOfThisThread();
  const TeamReport report = runTeam(2, {.pinning = Pinning::kFree}, [&](Member&) {
    const cpu_set_t own = test::maskOfThisThread();
    if (!CPU_EQUAL(&mask, &own)) throw std::runtime_error("the mask of a free member changed");
  });
  for (const MemberReport& member : report.members) {
    EXPECT_FALSE(member.pinned);
    EXPECT_EQ(member.pinning_note, "not asked for");
  }
}

}  // namespace
}  // namespace vehicle
