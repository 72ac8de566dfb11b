#include "libvehicle/threads/critical_path.h"

#include <gtest/gtest.h>

#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

using Kind = Span::Kind;

// Sums of a few times below 100 s: some ulps of them.
constexpr double kRounding = 1e-13;

TEST(CriticalPath, OfOneThreadIsItsComputing) {
  const Trace trace{.threads = 1,
                    .spans = {{0, 0, Kind::kCompute, 1.0, 3.0, -1}, {0, 16, Kind::kCompute, 9.0, 10.0, -1}}};
  const CriticalPath path = criticalPathOf(trace);
  EXPECT_EQ(path.steps, 2);
  EXPECT_WITHIN(path.seconds, 3.0, kRounding);
  EXPECT_WITHIN(path.computing[0], 3.0, kRounding);
  EXPECT_EQ(path.delivery, 0.0);
  EXPECT_TRUE(path.handovers.empty());
}

// Thread 0 computes 0..2 and 8..9 and waits 2..8 for thread 1, which computes 0..7 and then waits itself: 7 shown,
// 8 seen.
TEST(CriticalPath, AWaitLeadsToWhoWasWaitedForAndWhatLiesBetweenIsDelivery) {
  const Trace trace{.threads = 2,
                    .spans = {{0, 0, Kind::kCompute, 0.0, 2.0, -1},
                              {0, 0, Kind::kWait, 2.0, 8.0, 1},
                              {0, 0, Kind::kCompute, 8.0, 9.0, -1},
                              {1, 0, Kind::kCompute, 0.0, 7.0, -1},
                              {1, 0, Kind::kWait, 7.0, 8.5, 0}}};
  const CriticalPath path = criticalPathOf(trace);
  EXPECT_WITHIN(path.computing[0], 1.0, kRounding);
  EXPECT_WITHIN(path.computing[1], 7.0, kRounding);
  EXPECT_WITHIN(path.delivery, 1.0, kRounding);
  EXPECT_WITHIN(path.seconds, 9.0, kRounding);
  ASSERT_EQ(path.handovers.size(), 1u);
  EXPECT_EQ(path.handovers[0].from, 1);
  EXPECT_EQ(path.handovers[0].to, 0);
  EXPECT_EQ(path.handovers[0].count, 1);
}

// Thread 1 had been waiting since 1, so its values stood ready at 1: the wait of thread 0 from 2 on is the line's way.
TEST(CriticalPath, AWaitForValuesShownBeforeItBeganIsDeliveryAndNotTheOthersWork) {
  const Trace trace{.threads = 2,
                    .spans = {{0, 0, Kind::kCompute, 0.0, 2.0, -1},
                              {0, 0, Kind::kWait, 2.0, 3.0, 1},
                              {0, 0, Kind::kCompute, 3.0, 4.0, -1},
                              {1, 0, Kind::kCompute, 0.0, 1.0, -1},
                              {1, 0, Kind::kWait, 1.0, 3.5, 0}}};
  const CriticalPath path = criticalPathOf(trace);
  EXPECT_WITHIN(path.computing[0], 3.0, kRounding);
  EXPECT_EQ(path.computing[1], 0.0);
  EXPECT_WITHIN(path.delivery, 1.0, kRounding);
  EXPECT_TRUE(path.handovers.empty());
}

// 2 works 0..5, 1 waits for it until 6 and works 6..8, 0 waits for 1 until 9 and works 9..10.
TEST(CriticalPath, RunsThroughSeveralThreads) {
  const Trace trace{.threads = 3,
                    .spans = {{0, 0, Kind::kCompute, 0.0, 1.0, -1},
                              {0, 0, Kind::kWait, 1.0, 9.0, 1},
                              {0, 0, Kind::kCompute, 9.0, 10.0, -1},
                              {1, 0, Kind::kCompute, 0.0, 1.0, -1},
                              {1, 0, Kind::kWait, 1.0, 6.0, 2},
                              {1, 0, Kind::kCompute, 6.0, 8.0, -1},
                              {1, 0, Kind::kWait, 8.0, 9.5, 0},
                              {2, 0, Kind::kCompute, 0.0, 5.0, -1},
                              {2, 0, Kind::kWait, 5.0, 9.5, 1}}};
  const CriticalPath path = criticalPathOf(trace);
  EXPECT_WITHIN(path.computing[0], 1.0, kRounding);
  EXPECT_WITHIN(path.computing[1], 2.0, kRounding);
  EXPECT_WITHIN(path.computing[2], 5.0, kRounding);
  EXPECT_WITHIN(path.delivery, 2.0, kRounding);
  EXPECT_EQ(path.handovers.size(), 2u);
}

TEST(CriticalPath, OfAnEmptyTraceIsNothing) {
  EXPECT_EQ(criticalPathOf({}).steps, 0);
  EXPECT_EQ(criticalPathOf({.threads = 2}).seconds, 0.0);
}

}  // namespace
}  // namespace vehicle
