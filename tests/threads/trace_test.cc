#include "libvehicle/threads/trace.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "libvehicle/threads/exchange.h"
#include "libvehicle/threads/team.h"
#include "tests/support/tolerance.h"
#include "tests/support/watchdog.h"

namespace vehicle {
namespace {

// Member 0 works for `work` in every step, once member 1 is about to wait for it: on a busy machine that may come late.
// The other way round the answer comes at once.
void runSteps(Tracer& tracer, long steps, std::chrono::microseconds work) {
  test::Watchdog watchdog;
  Exchange exchange({1, 1});
  std::atomic<long> waits{-1};  // step of which member 1 is about to wait
  runTeam(2, {.tracer = &tracer}, [&](Member& me) {
    for (long step = 0; step < steps; ++step) {
      me.beginStep(step);
      if (me.number() == 0 && work.count() > 0) {
        while (waits < step) std::this_thread::yield();
        std::this_thread::sleep_for(work);
      }
      exchange.publish(me, step + 1);
      if (me.number() == 1) waits = step;
      (void)exchange.await(me, 1 - me.number(), step + 1);
      me.endStep(step);
    }
  });
}

TEST(Tracer, EveryNthStepIsTracedAndAllStepsOfMemberZeroAreCounted) {
  Tracer tracer(4);
  runSteps(tracer, 22, std::chrono::microseconds(0));
  const Trace trace = tracer.trace();
  EXPECT_EQ(trace.threads, 2);
  EXPECT_EQ(trace.every, 4);
  EXPECT_EQ(trace.traced_steps, 6);  // 0, 4, 8, 12, 16, 20
  EXPECT_EQ(trace.steps.count, 22);
  EXPECT_EQ(trace.dropped_steps, 0);
  EXPECT_EQ(trace.clock_note, "");
  for (const Span& span : trace.spans) EXPECT_EQ(span.step % 4, 0);
}

TEST(Tracer, SpansOfAThreadFollowEachOtherWithoutGapInsideAStep) {
  Tracer tracer(1);
  runSteps(tracer, 30, std::chrono::microseconds(20));
  const Trace trace = tracer.trace();
  ASSERT_GE(trace.spans.size(), 60u);
  for (std::size_t i = 1; i < trace.spans.size(); ++i) {
    const Span& before = trace.spans[i - 1];
    const Span& span = trace.spans[i];
    EXPECT_LE(span.begin_s, span.end_s);
    if (span.thread != before.thread) continue;
    if (span.step == before.step) {
      EXPECT_EQ(span.begin_s, before.end_s);
    } else {
      EXPECT_GE(span.begin_s, before.end_s);
      EXPECT_EQ(span.step, before.step + 1);
    }
  }
}

TEST(Tracer, AWaitNamesWhoWasWaitedForAndLastsAsLongAsItsWork) {
  Tracer tracer(1);
  constexpr long kSteps = 20;
  constexpr double kWork = 500e-6;
  runSteps(tracer, kSteps, std::chrono::microseconds(500));
  const Trace trace = tracer.trace();
  ASSERT_FALSE(trace.waits.empty());
  const WaitTotal& longest = trace.waits.front();
  EXPECT_EQ(longest.thread, 1);
  EXPECT_EQ(longest.for_whom, 0);
  EXPECT_GE(longest.count, 1);
  EXPECT_LE(longest.count, kSteps);
  // A sleep is never shorter than asked. Only where member 1 loses its core between its word and its wait may it find
  // all ready: it is enough that it waited a tenth of what the work takes.
  EXPECT_GT(longest.seconds, 0.1 * kWork * kSteps);
  EXPECT_GT(trace.steps.p50, 0.9 * kWork);
  EXPECT_GE(trace.steps.most, trace.steps.p999);
  EXPECT_GE(trace.run_seconds, kWork * kSteps);
}

// The histogram and the run's clock readings tell the same story: durations from end to end add up.
TEST(Tracer, StepDurationsAddUpToTheRun) {
  Tracer tracer(16);
  runSteps(tracer, 500, std::chrono::microseconds(0));
  const Trace trace = tracer.trace();
  const double sum = trace.steps.mean * static_cast<double>(trace.steps.count);
  EXPECT_WITHIN(sum, trace.run_seconds, 1e-12 * trace.run_seconds);  // rounding of one sum and one quotient
}

TEST(Tracer, AFullBufferDropsWholeStepsAndCountsThem) {
  Tracer tracer(1, 100);
  runSteps(tracer, 500, std::chrono::microseconds(0));
  const Trace trace = tracer.trace();
  EXPECT_GT(trace.dropped_steps, 0);
  EXPECT_LE(trace.spans.size(), 200u);
  EXPECT_EQ(trace.steps.count, 500);
}

TEST(Tracer, ItsOwnCostIsMeasured) {
  Tracer tracer(16);
  runSteps(tracer, 320, std::chrono::microseconds(0));
  const Trace trace = tracer.trace();
  // Between one cycle and what a system call costs: a counter that reads as free or as a call is not measured right.
  EXPECT_GT(trace.stamp_cost, 0.2e-9);
  EXPECT_LT(trace.stamp_cost, 2e-6);
  EXPECT_GE(trace.stamps, 320);
  EXPECT_GT(trace.overhead, 319 * trace.stamp_cost);
}

TEST(Tracer, IsReadyForAnotherTeam) {
  Tracer tracer(2);
  runSteps(tracer, 10, std::chrono::microseconds(0));
  runSteps(tracer, 6, std::chrono::microseconds(0));
  EXPECT_EQ(tracer.trace().traced_steps, 3);
  EXPECT_EQ(tracer.trace().steps.count, 6);
}

TEST(Tracer, BeforeARunThereIsNothing) {
  const Trace trace = Tracer().trace();
  EXPECT_EQ(trace.threads, 0);
  EXPECT_TRUE(trace.spans.empty());
  EXPECT_EQ(trace.steps.count, 0);
}

TEST(Tracer, ZeroIsNoInterval) {
  EXPECT_THROW(Tracer(0), std::invalid_argument);
  EXPECT_THROW(Tracer(1, 0), std::invalid_argument);
}

}  // namespace
}  // namespace vehicle
