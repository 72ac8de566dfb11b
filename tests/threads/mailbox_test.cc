#include "libvehicle/threads/mailbox.h"

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
TEST(Mailbox, RowsArriveOnceWholeAndInOrderUnderRandomDelays) {
  test::Watchdog watchdog;
  constexpr int kWidth = 5;
  constexpr long kRows = 3000;
  for (const int capacity : {1, 2, 3, 64}) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      Mailbox mailbox(kWidth, capacity);
      const auto delay = test::randomDelays(seed);
      std::thread writer([&] {
        std::array<double, kWidth> row{};
        for (long number = 0; number < kRows;) {
          for (int k = 0; k < kWidth; ++k) row[static_cast<std::size_t>(k)] = valueOf(number, k);
          if (mailbox.put(number, row)) {
            delay(0, number++);
          } else {
            std::this_thread::yield();
          }
        }
      });
      long wrong = 0;
      for (long expected = 0; expected < kRows;) {
        long number = -1;
        const double* row = mailbox.front(number);
        if (row == nullptr) {
          std::this_thread::yield();
          continue;
        }
        delay(1, expected);
        wrong += number != expected;
        for (int k = 0; k < kWidth; ++k) wrong += row[k] != valueOf(expected, k);
        mailbox.pop();
        ++expected;
      }
      writer.join();
      EXPECT_EQ(wrong, 0) << "capacity " << capacity << ", seed " << seed;
      long number = 0;
      EXPECT_EQ(mailbox.front(number), nullptr);
    }
  }
}

TEST(Mailbox, AFullOneTakesNothingAndLosesNothing) {
  Mailbox mailbox(1, 2);
  EXPECT_TRUE(mailbox.put(1, std::array{10.0}));
  EXPECT_TRUE(mailbox.put(2, std::array{20.0}));
  EXPECT_FALSE(mailbox.put(3, std::array{30.0}));
  long number = 0;
  EXPECT_EQ(*mailbox.front(number), 10.0);
  EXPECT_EQ(*mailbox.front(number), 10.0) << "looking takes nothing away";
  EXPECT_EQ(number, 1);
  mailbox.pop();
  EXPECT_TRUE(mailbox.put(3, std::array{30.0}));
  EXPECT_EQ(*mailbox.front(number), 20.0);
  mailbox.pop();
  EXPECT_EQ(*mailbox.front(number), 30.0);
  EXPECT_EQ(number, 3);
  mailbox.pop();
  EXPECT_EQ(mailbox.front(number), nullptr);
}

TEST(Mailbox, RefusesWhatDoesNotFit) {
  EXPECT_THROW(Mailbox(-1, 1), std::invalid_argument);
  EXPECT_THROW(Mailbox(1, 0), std::invalid_argument);
  Mailbox mailbox(2, 1);
  try {
    (void)mailbox.put(0, std::array{1.0, 2.0, 3.0});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "mailbox: a row of 3 values, must have 2");
  }
}

}  // namespace
}  // namespace vehicle
