#include "libvehicle/threads/spsc_ring.h"

#include <array>
#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "tests/support/delays.h"
#include "tests/support/watchdog.h"

namespace vehicle {
namespace {

double valueOf(long number, int column) {
  return static_cast<double>(test::scrambled(static_cast<std::uint64_t>(number), static_cast<std::uint64_t>(column)) >>
                             12);
}

// One thread writes, one reads, both delayed at random: every row arrives once, whole and in order.
TEST(SpscRing, RowsArriveOnceWholeAndInOrderUnderRandomDelays) {
  test::Watchdog watchdog;
  constexpr int kWidth = 5;
  constexpr long kRows = 3000;
  // A batch that is longer than the ring, or no divisor of it, must not make the two wait for each other.
  for (const auto& [capacity, batch] : {std::array{1, 1}, {2, 1}, {3, 1}, {64, 1}, {64, 16}, {10, 4}, {3, 7}}) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      SpscRing ring(kWidth, capacity, batch);
      const auto delay = test::randomDelays(seed);
      std::thread writer([&] {
        std::array<double, kWidth> row{};
        for (long number = 0; number < kRows;) {
          for (int k = 0; k < kWidth; ++k) row[static_cast<std::size_t>(k)] = valueOf(number, k);
          if (ring.put(number, row)) {
            delay(0, number++);
          } else {
            std::this_thread::yield();
          }
        }
        ring.flush();
      });
      long wrong = 0;
      for (long expected = 0; expected < kRows;) {
        long number = -1;
        const double* row = ring.front(number);
        if (row == nullptr) {
          std::this_thread::yield();
          continue;
        }
        delay(1, expected);
        wrong += number != expected;
        for (int k = 0; k < kWidth; ++k) wrong += row[k] != valueOf(expected, k);
        ring.pop();
        ++expected;
      }
      writer.join();
      EXPECT_EQ(wrong, 0) << "capacity " << capacity << ", batch " << batch << ", seed " << seed;
      long number = 0;
      EXPECT_EQ(ring.front(number), nullptr);
    }
  }
}

TEST(SpscRing, AFullOneTakesNothingAndLosesNothing) {
  SpscRing ring(1, 2);
  EXPECT_TRUE(ring.put(1, std::array{10.0}));
  EXPECT_TRUE(ring.put(2, std::array{20.0}));
  EXPECT_FALSE(ring.put(3, std::array{30.0}));
  long number = 0;
  EXPECT_EQ(*ring.front(number), 10.0);
  EXPECT_EQ(*ring.front(number), 10.0) << "looking takes nothing away";
  EXPECT_EQ(number, 1);
  ring.pop();
  EXPECT_TRUE(ring.put(3, std::array{30.0}));
  EXPECT_EQ(*ring.front(number), 20.0);
  ring.pop();
  EXPECT_EQ(*ring.front(number), 30.0);
  EXPECT_EQ(number, 3);
  ring.pop();
  EXPECT_EQ(ring.front(number), nullptr);
}

TEST(SpscRing, ABatchIsShownWholeOrByFlush) {
  SpscRing ring(1, 8, 3);
  long number = 0;
  EXPECT_TRUE(ring.put(0, std::array{0.0}));
  EXPECT_TRUE(ring.put(1, std::array{1.0}));
  EXPECT_EQ(ring.front(number), nullptr);
  EXPECT_TRUE(ring.put(2, std::array{2.0}));
  EXPECT_EQ(*ring.front(number), 0.0);
  for (int i = 0; i < 3; ++i) ring.pop();
  EXPECT_TRUE(ring.put(3, std::array{3.0}));
  EXPECT_EQ(ring.front(number), nullptr);
  ring.flush();
  EXPECT_EQ(*ring.front(number), 3.0);
  EXPECT_EQ(number, 3);
  EXPECT_EQ(ring.count(), 4);
}

TEST(SpscRing, RefusesWhatDoesNotFit) {
  EXPECT_THROW(SpscRing(-1, 1), std::invalid_argument);
  EXPECT_THROW(SpscRing(1, 0), std::invalid_argument);
  EXPECT_THROW(SpscRing(1, 1, 0), std::invalid_argument);
  SpscRing ring(2, 1);
  try {
    (void)ring.put(0, std::array{1.0, 2.0, 3.0});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "ring: a row of 3 values, must have 2");
  }
}

}  // namespace
}  // namespace vehicle
