#include "libvehicle/threads/team.h"

#include <atomic>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <sys/resource.h>

#include <gtest/gtest.h>

#include "libvehicle/threads/exchange.h"
#include "libvehicle/threads/placement.h"
#include "tests/support/delays.h"
#include "tests/support/watchdog.h"

namespace vehicle {
namespace {

// Everybody exchanges with everybody; `at` is called after each epoch.
void exchangeAll(Member& me, Exchange& exchange, long epochs, const std::function<void(long)>& at) {
  for (long epoch = 1; epoch <= epochs; ++epoch) {
    *exchange.slot(me.number(), epoch) = static_cast<double>(epoch);
    exchange.publish(me, epoch);
    for (int other = 0; other < me.threads(); ++other) {
      if (other != me.number() && *exchange.await(me, other, epoch) != static_cast<double>(epoch)) {
        throw std::logic_error("wrong value");
      }
    }
    at(epoch);
  }
}

TEST(Team, EveryMemberWorksOnceUnderItsNumber) {
  for (int threads = 1; threads <= 8; ++threads) {
    std::vector<std::atomic<int>> calls(static_cast<std::size_t>(threads));
    const TeamReport report = runTeam(threads, {}, [&](Member& me) {
      EXPECT_EQ(me.threads(), threads);
      ++calls[static_cast<std::size_t>(me.number())];
    });
    EXPECT_EQ(report.members.size(), static_cast<std::size_t>(threads));
    for (const auto& count : calls) EXPECT_EQ(count, 1);
  }
}

// All threads exist before the first one works: counted by the kernel while nobody may leave.
TEST(Team, MembersAreReleasedTogether) {
  test::Watchdog watchdog;
  for (const int threads : {2, 5, 8}) {
    std::atomic<int> counted{0};
    std::atomic<int> fewest{1000};
    runTeam(threads, {}, [&](Member& me) {
      int alive = 0;
      for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) alive += !entry.path().empty();
      int before = fewest;
      while (alive < before && !fewest.compare_exchange_weak(before, alive)) {
      }
      ++counted;
      me.wait([&] { return counted == threads; }, 0);
    });
    EXPECT_GE(fewest, threads + 1);  // and the caller
  }
}

TEST(Team, AnExceptionOfAnyMemberAtAnyEpochStopsAllAndReachesTheCaller) {
  test::Watchdog watchdog;
  constexpr long kEpochs = 12;
  for (const int threads : {1, 2, 3, 5}) {
    for (int thrower = 0; thrower < threads; ++thrower) {
      for (long when = 1; when <= kEpochs; ++when) {
        TeamPolicy policy;
        policy.injectDelay = test::randomDelays(static_cast<std::uint64_t>(when));
        Exchange exchange(std::vector<int>(static_cast<std::size_t>(threads), 1));
        try {
          runTeam(threads, policy, [&](Member& me) {
            exchangeAll(me, exchange, kEpochs, [&](long epoch) {
              if (me.number() == thrower && epoch == when)
                throw std::runtime_error("member " + std::to_string(thrower));
            });
          });
          ADD_FAILURE() << "no exception";
        } catch (const std::runtime_error& error) {
          EXPECT_EQ(error.what(), "member " + std::to_string(thrower));
        }
      }
    }
  }
}

TEST(Team, AStopByAnyMemberAtAnyEpochEndsTheRunWithoutAnException) {
  test::Watchdog watchdog;
  constexpr long kEpochs = 12;
  for (const int threads : {1, 2, 3, 5}) {
    for (int stopper = 0; stopper < threads; ++stopper) {
      for (long when = 1; when <= kEpochs; ++when) {
        Exchange exchange(std::vector<int>(static_cast<std::size_t>(threads), 1));
        std::atomic<int> ended{0};
        runTeam(threads, {}, [&](Member& me) {
          bool leave = false;
          for (long epoch = 1; epoch <= kEpochs && !leave; ++epoch) {
            exchange.publish(me, epoch);
            for (int other = 0; other < threads; ++other) {
              if (other != me.number()) (void)exchange.await(me, other, epoch);
            }
            leave = me.number() == stopper && epoch == when;
            if (leave) me.stopTeam();
          }
          EXPECT_TRUE(!leave || me.stopped());
          ++ended;
        });
        EXPECT_GE(ended, 1);
      }
    }
  }
}

// Several members throw: one of the messages arrives, none is lost in a crash.
TEST(Team, TheFirstOfManyExceptionsIsTheOneThatArrives) {
  test::Watchdog watchdog;
  for (int round = 0; round < 50; ++round) {
    try {
      runTeam(4, {}, [](Member& me) { throw std::runtime_error(std::to_string(me.number())); });
      ADD_FAILURE() << "no exception";
    } catch (const std::runtime_error& error) {
      EXPECT_LT(std::stoi(error.what()), 4);
    }
  }
}

TEST(Team, AWaitForWhatNeverComesEndsWhenTheTeamIsStoppedWhateverThePolicy) {
  test::Watchdog watchdog;
  for (const std::string& waiting : waitingNames()) {
    const int threads = std::min(2, static_cast<int>(allowedCores().size()));
    if (threads < 2) break;
    runTeam(threads, {.waiting = waitingKindOf(waiting)}, [](Member& me) {
      if (me.number() == 1) {
        std::this_thread::sleep_for(std::chrono::milliseconds(3));
        me.stopTeam();
      } else {
        me.wait([] { return false; }, 1);
        ADD_FAILURE() << "the wait returned";
      }
    });
  }
}

TEST(Team, WrongChoicesAreRefusedBeforeAThreadStarts) {
  const auto never = [](Member&) { ADD_FAILURE() << "started"; };
  try {
    runTeam(0, {}, never);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "team: threads = 0, must be >= 1");
  }
  const int one_too_many = static_cast<int>(allowedCores().size()) + 1;
  EXPECT_THROW(runTeam(one_too_many, {.waiting = WaitingKind::kSpin}, never), std::invalid_argument);
  try {
    runTeam(1, {.priority = Priority::kFifo, .waiting = WaitingKind::kYield}, never);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "waiting \"yield\" with SCHED_FIFO could lock the machine; take auto | sleep");
  }
}

TEST(Team, TheReportSaysWhichPriorityWasGotAndWhyNotMore) {
  for (const MemberReport& member : runTeam(1, {}, [](Member&) {}).members) {
    EXPECT_EQ(member.priority, "normal");
    EXPECT_EQ(member.priority_note, "");
  }
  const int before = getpriority(PRIO_PROCESS, 0);
  std::atomic<int> nice{0};
  const TeamReport raised =
      runTeam(1, {.priority = Priority::kRaised}, [&](Member&) { nice = getpriority(PRIO_PROCESS, 0); });
  const MemberReport& member = raised.members.front();
  if (member.priority == "normal") {
    EXPECT_NE(member.priority_note.find("nice -10 was refused ("), std::string::npos) << member.priority_note;
    EXPECT_NE(member.priority_note.find("ulimit -e"), std::string::npos) << member.priority_note;
    EXPECT_EQ(nice, before);
  } else {
    EXPECT_EQ(member.priority, "nice " + std::to_string(nice));
    EXPECT_LT(nice, before);
  }
  EXPECT_EQ(getpriority(PRIO_PROCESS, 0), before) << "the caller keeps its own";
}

TEST(Team, RealTimePriorityIsGivenOnlyWithACoreToSpare) {
  const int all = static_cast<int>(allowedCores().size());
  std::atomic<bool> fifo{false};
  const TeamReport full =
      runTeam(all, {.priority = Priority::kFifo}, [&](Member&) { fifo = fifo || sched_getscheduler(0) == SCHED_FIFO; });
  EXPECT_FALSE(fifo);
  EXPECT_EQ(full.members.front().priority_note.find("SCHED_FIFO needs a core to spare"), 0u)
      << full.members.front().priority_note;
  if (all < 2) return;
  const TeamReport spare =
      runTeam(all - 1, {.priority = Priority::kFifo}, [&](Member&) { fifo = sched_getscheduler(0) == SCHED_FIFO; });
  const MemberReport& member = spare.members.front();
  EXPECT_EQ(fifo, member.priority == "SCHED_FIFO 10") << member.priority;
  EXPECT_EQ(!fifo, member.priority_note.starts_with("SCHED_FIFO was refused (")) << member.priority_note;
}

TEST(Team, ManyMoreThreadsThanCoresStillExchange) {
  test::Watchdog watchdog;
  constexpr int kThreads = 24;
  Exchange exchange(std::vector<int>(kThreads, 1));
  runTeam(kThreads, {}, [&](Member& me) { exchangeAll(me, exchange, 40, [](long) {}); });
}

}  // namespace
}  // namespace vehicle
