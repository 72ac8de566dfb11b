#include "libvehicle/threads/exchange.h"

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/delays.h"
#include "tests/support/watchdog.h"

namespace vehicle {
namespace {

using test::scrambled;

// Thread i computes values from all values of its neighbours one epoch before: a wrong, old, new or torn value
// anywhere changes every number after it.
struct Network {
  std::vector<int> values;                   // of each thread
  std::vector<std::vector<int>> neighbours;  // symmetric

  Network(int threads, std::uint64_t seed) {
    const auto n = static_cast<std::size_t>(threads);
    neighbours.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      values.push_back(static_cast<int>(scrambled(seed, i) % 20));
      for (std::size_t j = 0; j < i; ++j) {
        if (scrambled(seed, i, j + 1) % 3 == 0) continue;
        neighbours[i].push_back(static_cast<int>(j));
        neighbours[j].push_back(static_cast<int>(i));
      }
    }
  }

  template <class ValuesOf>
  void next(int thread, long epoch, ValuesOf values_of, double* own) const {
    const auto me = static_cast<std::size_t>(thread);
    double sum = static_cast<double>(scrambled(me, static_cast<std::uint64_t>(epoch)) % 1000);
    for (const int other : neighbours[me]) {
      const double* seen = values_of(other);
      for (int k = 0; k < values[static_cast<std::size_t>(other)]; ++k) sum = 0.7 * sum + (k + 1) * seen[k];
    }
    for (int k = 0; k < values[me]; ++k)
      own[k] = std::fmod(sum, 1e3) / (k + 2.0);  // bounded: what grows ends as NaN, which equals nothing
  }
};

using Log = std::vector<std::vector<double>>;  // shape (threads)(epochs x values)

Log serial(const Network& network, long epochs) {
  const std::size_t n = network.values.size();
  Log log(n);
  std::vector<std::vector<double>> before(n), after(n);
  for (std::size_t i = 0; i < n; ++i) {
    before[i].resize(static_cast<std::size_t>(network.values[i]), 0.0);
    after[i] = before[i];
  }
  for (long epoch = 1; epoch <= epochs; ++epoch) {
    for (std::size_t i = 0; i < n; ++i) {
      network.next(
          static_cast<int>(i), epoch, [&](int other) { return before[static_cast<std::size_t>(other)].data(); },
          after[i].data());
      log[i].insert(log[i].end(), after[i].begin(), after[i].end());
    }
    before = after;
  }
  return log;
}

Log exchanged(const Network& network, long epochs, const TeamPolicy& policy) {
  const int threads = static_cast<int>(network.values.size());
  Exchange exchange(network.values);
  Log log(network.values.size());
  runTeam(threads, policy, [&](Member& me) {
    std::vector<double>& mine = log[static_cast<std::size_t>(me.number())];
    const int count = exchange.values(me.number());
    for (long epoch = 1; epoch <= epochs; ++epoch) {
      double* own = exchange.slot(me.number(), epoch);
      network.next(
          me.number(), epoch,
          [&](int other) {
            const double* seen = epoch == 1 ? exchange.slot(other, 0) : exchange.await(me, other, epoch - 1);
            me.injectDelay(-epoch);  // between the look and the read
            return seen;
          },
          own);
      mine.insert(mine.end(), own, own + count);
      exchange.publish(me, epoch);
    }
  });
  return log;
}

TEST(Exchange, DeliversThePublishedValuesForEveryThreadCountUnderRandomDelays) {
  test::Watchdog watchdog;
  constexpr long kEpochs = 120;
  for (int threads = 1; threads <= 8; ++threads) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const Network network(threads, seed);
      TeamPolicy policy;
      policy.injectDelay = test::randomDelays(seed);
      policy.waiting = seed % 3 == 0 ? WaitingKind::kYield : seed % 3 == 1 ? WaitingKind::kSleep : WaitingKind::kAuto;
      policy.pinning = seed % 2 == 0 ? Pinning::kCores : Pinning::kFree;
      EXPECT_EQ(exchanged(network, kEpochs, policy), serial(network, kEpochs)) << threads << " threads, seed " << seed;
    }
  }
}

TEST(Exchange, DeliversThePublishedValuesAtFullSpeed) {
  test::Watchdog watchdog;
  constexpr long kEpochs = 20'000;
  for (const int threads : {2, 3}) {
    const Network network(threads, 7);
    EXPECT_EQ(exchanged(network, kEpochs, {}), serial(network, kEpochs)) << threads << " threads";
  }
}

// Lines that two owners write would travel at every store of either.
TEST(Exchange, OwnersShareNoCacheLineAndCounterAndValuesDo) {
  Exchange exchange({7, 8, 0, 30});
  const auto address = [&](int owner, long epoch) {
    return reinterpret_cast<std::uintptr_t>(exchange.slot(owner, epoch));
  };
  for (int owner = 0; owner < exchange.threads(); ++owner) {
    for (const long epoch : {1L, 2L}) {
      EXPECT_EQ(address(owner, epoch) % 64, sizeof(double)) << "the counter stands before the values";
      const std::uintptr_t end =
          address(owner, epoch) + sizeof(double) * static_cast<std::size_t>(exchange.values(owner));
      if (epoch == 1) {
        EXPECT_NE(address(owner, 2) / 64, (end - 1) / 64);
      }
      for (int other = owner + 1; other < exchange.threads(); ++other) {
        EXPECT_GT(address(other, 0) / 128, (end - 1) / 128) << owner << " and " << other;
      }
    }
  }
  EXPECT_EQ(address(0, 1), address(0, 3));
  EXPECT_NE(address(0, 1), address(0, 2));
}

TEST(Exchange, RefusesWhatIsNoExchange) {
  EXPECT_THROW(Exchange({}), std::invalid_argument);
  try {
    Exchange exchange({3, -1});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "exchange: thread 1 shows -1 values, must be >= 0");
  }
}

}  // namespace
}  // namespace vehicle
