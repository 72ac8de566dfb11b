#include "libvehicle/realtime/realtime.h"

#include <sched.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/integrate/fixed_steps.h"
#include "libvehicle/integrate/rk4.h"
#include "libvehicle/threads/placement.h"
#include "tests/support/delays.h"
#include "tests/support/watchdog.h"

namespace vehicle {
namespace {

using State = std::array<double, 2>;

constexpr double kPeriod = 1e-3;
constexpr int kWidth = 2;  // one height, one rate

// A mass of 1 Hz on spring and damper over the rail.
struct Mass {
  void operator()(const double* x, const double* u, double* dx) const {
    dx[0] = x[1];
    dx[1] = 39.5 * (u[0] - x[0]) + 2.5 * (u[1] - x[1]);
  }
};

Input waves(double end) {
  InputSegment segment;
  segment.end = end;
  segment.angular_frequency = {7.0, 31.0};
  segment.cosine = {0.01, 0.0};
  segment.sine = {0.0, 0.003};
  segment.polynomial = {0.002, 0.0, 0.0, 0.0};
  return Input(1, {segment});
}

// Begin, middle and end of every step, shape (steps)(3 x kWidth).
std::vector<std::vector<double>> rowsOf(const Input& input, long steps) {
  std::vector<double> half(static_cast<std::size_t>(2 * steps + 1) * kWidth);
  input.sweep(0, input.begin(), 0.5 * kPeriod, static_cast<int>(2 * steps + 1), half);
  std::vector<std::vector<double>> rows;
  for (long i = 0; i < steps; ++i) {
    const auto begin = half.begin() + 2 * i * kWidth;
    rows.emplace_back(begin, begin + 3 * kWidth);
  }
  return rows;
}

State steppedOffline(State x, const std::vector<std::vector<double>>& rows) {
  Rk4<Mass, 2> rk4{Mass{}};
  for (const auto& row : rows) rk4.step(kPeriod, row.data(), row.data() + kWidth, row.data() + 2 * kWidth, x.data());
  return x;
}

class RealtimeMass {
 public:
  RealtimeStep step() {
    return [this](const double* u, double* x) {
      given.emplace_back(u, u + 3 * kWidth);
      if (before) before(static_cast<long>(given.size()) - 1);
      rk4_.step(kPeriod, u, u + kWidth, u + 2 * kWidth, x);
    };
  }
  std::vector<std::vector<double>> given;  // the inputs that the steps saw
  std::function<void(long step)> before;

 private:
  Rk4<Mass, 2> rk4_{Mass{}};
};

/// Whether a thread of this process sleeps, for a release or for anything else.
bool sleeps(pid_t thread) {
  std::ifstream stream("/proc/self/task/" + std::to_string(thread) + "/stat");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return text[text.rfind(')') + 2] == 'S';
}

constexpr RealtimeChoice kModest{.priority = Priority::kNormal, .memory = RealtimeChoice::Memory::kPaged};

TEST(Realtime, WithEveryInputInTimeTheNumbersAreThoseOfTheOfflineRun) {
  test::Watchdog watchdog;
  constexpr long kSteps = 100;
  const Input input = waves(kSteps * kPeriod);
  const auto rows = rowsOf(input, kSteps);
  SpscRing in(3 * kWidth, kSteps), out(2, kSteps);
  for (long i = 0; i < kSteps; ++i) ASSERT_TRUE(in.put(i, rows[static_cast<std::size_t>(i)]));
  State x{0.01, -0.02};
  const State start = x;
  RealtimeMass mass;
  const RealtimeReport report = runRealtime(mass.step(), x, {kPeriod, kSteps}, kModest, {&in, &out});
  EXPECT_EQ(report.steps, kSteps);
  EXPECT_EQ(report.inputs_held, 0);
  EXPECT_EQ(report.inputs_late, 0);
  EXPECT_EQ(report.outputs_lost, 0);
  EXPECT_FALSE(report.stopped);

  Rk4<Mass, 2> rk4{Mass{}};
  std::vector<State> offline;
  FixedSteps(rk4, input, {kPeriod})
      .run(Schedule(input, kPeriod), start, [&](int, int, double, std::span<const double> now) {
        offline.push_back({now[0], now[1]});
        return true;
      });
  ASSERT_EQ(offline.size(), static_cast<std::size_t>(kSteps) + 1);
  EXPECT_EQ(x, offline.back());
  for (long i = 1; i <= kSteps; ++i) {
    long number = 0;
    const double* row = out.front(number);
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(number, i);
    EXPECT_EQ((State{row[0], row[1]}), offline[static_cast<std::size_t>(i)]);
    out.pop();
  }
}

TEST(Realtime, AMissingInputHoldsTheNewestValueAndALateOneIsCounted) {
  test::Watchdog watchdog;
  const auto rows = rowsOf(waves(1.0), 6);
  SpscRing in(3 * kWidth, 8);
  const auto put = [&](std::size_t i) { ASSERT_TRUE(in.put(static_cast<long>(i), rows[i])); };
  put(1);  // nothing for step 0
  put(2);
  put(4);  // 3 comes late
  put(3);
  State x{};
  RealtimeMass mass;
  const RealtimeReport report = runRealtime(mass.step(), x, {kPeriod, 6}, kModest, {&in});
  const auto held = [&](std::size_t i) {
    const double* end = rows[i].data() + 2 * kWidth;
    return std::vector<double>{end[0], end[1], end[0], end[1], end[0], end[1]};
  };
  const std::vector<std::vector<double>> expected = {
      std::vector<double>(3 * kWidth, 0.0), rows[1], rows[2], held(2), rows[4], held(4)};
  EXPECT_EQ(mass.given, expected);
  EXPECT_EQ(report.inputs_held, 3);
  EXPECT_EQ(report.inputs_late, 1);
  EXPECT_EQ(x, steppedOffline({}, expected));
}

// Rows come and go while the clock runs. Some may be late on a busy machine: what the steps were given is what the
// numbers must follow from, and the counts must agree with it.
TEST(Realtime, InputsAndOutputsArePassedWhileTheClockRuns) {
  test::Watchdog watchdog;
  constexpr long kSteps = 150;
  const auto rows = rowsOf(waves(1.0), kSteps);
  SpscRing in(3 * kWidth, 16), out(2, 16);
  const auto delay = test::randomDelays(3);
  std::atomic<bool> over{false};
  std::thread writer([&] {
    for (long i = 0; i < kSteps && !over;) {
      if (in.put(i, rows[static_cast<std::size_t>(i)])) {
        delay(0, i++);
      } else {
        std::this_thread::sleep_for(std::chrono::microseconds(200));
      }
    }
  });
  long seen = 0;
  std::thread reader([&] {
    long last = 0;
    while (!over) {
      long number = 0;
      if (out.front(number) != nullptr) {
        EXPECT_GT(number, last);
        last = number;
        ++seen;
        out.pop();
      } else {
        std::this_thread::sleep_for(std::chrono::microseconds(200));
      }
    }
  });
  State x{};
  RealtimeMass mass;
  const RealtimeReport report = runRealtime(mass.step(), x, {kPeriod, kSteps}, kModest, {&in, &out});
  over = true;
  writer.join();
  reader.join();
  EXPECT_EQ(x, steppedOffline({}, mass.given));
  EXPECT_LE(seen, kSteps - report.outputs_lost);
  EXPECT_GE(seen, kSteps - report.outputs_lost - out.capacity());
  long as_sent = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) as_sent += mass.given[i] == rows[i];
  EXPECT_EQ(as_sent, kSteps - report.inputs_held);
}

TEST(Realtime, AStepThatTakesTooLongMissesItsDeadlineAndIsNotCaughtUp) {
  test::Watchdog watchdog;
  constexpr long kSteps = 10;
  constexpr double kLong = 5e-3;  // [s] a period that a busy machine rarely exceeds
  State x{};
  RealtimeMass mass;
  mass.before = [](long step) {
    if (step == 4) std::this_thread::sleep_for(std::chrono::milliseconds(17));
  };
  const auto begin = std::chrono::steady_clock::now();
  SpscRing in(3 * kWidth, 1);
  const RealtimeReport report = runRealtime(mass.step(), x, {kLong, kSteps}, kModest, {&in});
  const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_EQ(report.steps, kSteps);
  EXPECT_GE(report.deadline_misses, 1);
  EXPECT_GE(report.skipped_releases, 3);  // 17 ms are over three periods of 5 ms
  EXPECT_GE(report.step.most, 17e-3);
  EXPECT_GE(report.response.most, report.step.most);
  // Every step had a release of its own, the skipped ones besides.
  EXPECT_GE(took, static_cast<double>(kSteps - 1 + report.skipped_releases) * kLong);
}

TEST(Realtime, NoStepBeginsBeforeItsRelease) {
  test::Watchdog watchdog;
  constexpr long kSteps = 40;
  State x{};
  RealtimeMass mass;
  std::vector<double> began;
  const auto now = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
  mass.before = [&](long) { began.push_back(now()); };
  SpscRing in(3 * kWidth, 1);
  const double called = now();
  const RealtimeReport report = runRealtime(mass.step(), x, {kPeriod, kSteps}, kModest, {&in});
  ASSERT_EQ(began.size(), static_cast<std::size_t>(kSteps));
  EXPECT_EQ(report.wake_up.count, kSteps);
  // The first release comes a period after the call, and every other one a period or more after the one before: on a
  // busy machine late by anything, never early. 1e-9 s is the rounding of the clock.
  for (std::size_t i = 0; i < began.size(); ++i) {
    EXPECT_GE(began[i], called + static_cast<double>(i + 1) * kPeriod - 1e-9) << i;
  }
  EXPECT_GE(report.response.p50, report.wake_up.least);
}

TEST(Realtime, IsStoppedFromOutsideEvenInALongSleep) {
  test::Watchdog watchdog;
  for (const double period : {1e-3, 3000.0}) {
    std::atomic<bool> stop{false};
    RealtimeChoice choice = kModest;
    choice.stop = &stop;
    std::thread stopper([&stop, runner = ::gettid()] {
      while (!sleeps(runner)) std::this_thread::sleep_for(std::chrono::microseconds(100));
      stop = true;
    });
    State x{};
    RealtimeMass mass;
    SpscRing in(3 * kWidth, 1);
    const RealtimeReport report = runRealtime(mass.step(), x, {.period = period}, choice, {&in});
    stopper.join();
    EXPECT_TRUE(report.stopped);
    EXPECT_EQ(report.steps, static_cast<long>(mass.given.size()));
  }
}

TEST(Realtime, WhatTheSystemGrantedIsReportedAndGivenBack) {
  State x{};
  RealtimeMass mass;
  std::atomic<bool> fifo{false};
  mass.before = [&](long) { fifo = sched_getscheduler(0) == SCHED_FIFO; };
  SpscRing in(3 * kWidth, 1);
  const RealtimeReport report = runRealtime(mass.step(), x, {kPeriod, 3}, {}, {&in});
  EXPECT_EQ(fifo, report.thread.priority.starts_with("SCHED_FIFO"));
  EXPECT_NE(report.thread.priority.starts_with("SCHED_FIFO"), report.thread.priority_note.find("SCHED_FIFO") == 0);
  EXPECT_NE(report.memory_locked, !report.memory_note.empty());
  EXPECT_EQ(sched_getscheduler(0), SCHED_OTHER) << "the caller keeps its own";
  EXPECT_GE(report.thread.usage.wall, 3 * kPeriod);
}

TEST(Realtime, AFullOutputIsLostAndCountedAndNobodyWaits) {
  State x{};
  RealtimeMass mass;
  SpscRing in(3 * kWidth, 1), out(2, 4);
  const RealtimeReport report = runRealtime(mass.step(), x, {kPeriod, 10}, kModest, {&in, &out});
  EXPECT_EQ(report.outputs_lost, 6);
  EXPECT_EQ(report.steps, 10);
}

TEST(Realtime, AStateThatIsNoLongerFiniteEndsTheRunWithItsTime) {
  State x{1.0, 0.0};
  const RealtimeStep explode = [](const double* u, double* state) {
    EXPECT_EQ(u, nullptr);
    state[1] = std::numeric_limits<double>::infinity();
  };
  try {
    runRealtime(explode, x, {kPeriod, 5}, kModest, {});
    FAIL() << "went on";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "realtime: state 1 is no longer finite (the step is too long for the fastest motion, or the system is "
                 "unstable) at t = 0.001 s");
  }
}

TEST(Realtime, NoStepAtAllLeavesTheState) {
  State x{1.0, 2.0};
  RealtimeMass mass;
  const RealtimeReport report = runRealtime(mass.step(), x, {kPeriod, 0}, kModest, {});
  EXPECT_EQ(report.steps, 0);
  EXPECT_EQ(report.wake_up.count, 0);
  EXPECT_EQ(x, (State{1.0, 2.0}));
}

TEST(Realtime, RefusesWhatDoesNotFit) {
  const RealtimeStep never = [](const double*, double*) { ADD_FAILURE() << "stepped"; };
  const auto refusal = [&](ReleaseClock clock, std::vector<double> x, int in_width, int out_width) -> std::string {
    SpscRing in(in_width, 1), out(out_width, 1);
    try {
      runRealtime(never, x, clock, kModest, {&in, &out});
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refusal({0.0, 1}, {1.0}, 3, 1), "realtime: period = 0.000000 s, must be between 1e-6 s and 3600 s");
  EXPECT_NE(refusal({std::numeric_limits<double>::quiet_NaN(), 1}, {1.0}, 3, 1), "accepted");
  EXPECT_EQ(refusal({1e-3, -1}, {1.0}, 3, 1), "realtime: steps = -1, must be >= 0");
  EXPECT_EQ(refusal({1e-3, 1}, {1.0}, 4, 1),
            "realtime: rows of the input have 4 values, must be three times the input: begin, middle and end of "
            "a step");
  EXPECT_EQ(refusal({1e-3, 1}, {1.0}, 3, 2), "realtime: rows of the output have 2 values, must have 1, one a state");
  EXPECT_NE(refusal({1e-3, 1}, {std::numeric_limits<double>::infinity()}, 3, 1), "accepted");
}

}  // namespace
}  // namespace vehicle
