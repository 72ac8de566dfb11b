#include "libvehicle/partition/choose.h"

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/integrate/step_walk.h"
#include "tests/support/eight_states.h"
#include "tests/support/paper_matrices.h"

namespace vehicle::test {
namespace {

/// A clock that only the ways of a test advance [s]: what is decided does not depend on the machine.
class TestClock {
 public:
  void pass(double seconds) { now_ += seconds; }
  [[nodiscard]] double now() const { return now_; }

  /// Walks through the schedule and takes that long a step [s].
  [[nodiscard]] Way pacedWay(Scheme scheme, int threads, std::function<double()> step_time) {
    return {scheme, threads, [this, step_time](const Input&, const Schedule& schedule, const Observer& observe) {
              const std::vector<double> x(8, 0.0);
              if (!observe(0, 0, 0.0, x)) return;
              const double step = step_time();
              for (const Interval interval : schedule.intervals()) {
                pass(step * stepsOf(interval.end - interval.begin, {1e-3}));
                if (interval.sample >= 0 && !observe(interval.sample, interval.next, interval.end, x)) return;
              }
            }};
  }
  [[nodiscard]] Way pacedWay(Scheme scheme, int threads, double step_time) {
    return pacedWay(scheme, threads, [step_time] { return step_time; });
  }

 private:
  double now_ = 0.0;
};

/// Long enough that a step of a tenth of a microsecond is worth a calibration.
struct LongRun {
  TestClock clock;
  EightStates system;
  Input input = paperExtended(10000.0);
  Schedule schedule{input, 10000.0};
  RunProblem run{system, input, schedule};
  TuningProblem problem{.run = run, .steps = stepsOfRun(schedule, {1e-3}), .now = [this] { return clock.now(); }};
};

TEST(Choose, CountsTheStepsOfARun) {
  EXPECT_EQ(LongRun().problem.steps, 10'000'000);
  const Input onset = paperOnset(10.0);
  EXPECT_EQ(stepsOfRun(Schedule(onset, 5e-3), {1e-3}), 10'002);  // two breakpoints cut a step in halves
}

TEST(Choose, LooksAtPowersOfTwoAndAtAllCores) {
  EXPECT_EQ(threadCounts(1), std::vector<int>{});
  EXPECT_EQ(threadCounts(2), std::vector<int>{2});
  EXPECT_EQ(threadCounts(6), (std::vector<int>{2, 4, 6}));
  EXPECT_EQ(threadCounts(8), (std::vector<int>{2, 4, 8}));
}

TEST(Choose, TakesTheFirstWayWithoutATrialWhereTheRunIsShort) {
  const EightStates system;
  const Input input = paperExtended(10.0);
  const Schedule schedule(input, 5e-3);
  const Way never = {Scheme::kPipeline, 2, [](const Input&, const Schedule&, const Observer&) { FAIL() << "tried"; }};
  const RunProblem run{system, input, schedule};
  const Decision made = chooseWay({.run = run, .steps = 10'000}, {{Scheme::kSerial, 1, never.run}, never});
  EXPECT_EQ(made.scheme, Scheme::kSerial);
  EXPECT_NE(made.reason.find("too short to try others"), std::string::npos) << made.reason;
  EXPECT_EQ(made.candidates.size(), 2u);
}

TEST(Choose, TakesTheWayThatIsFasterAndSaysByHowMuch) {
  LongRun run;
  const Decision made = chooseWay(
      run.problem, {run.clock.pacedWay(Scheme::kSerial, 1, 2e-7), run.clock.pacedWay(Scheme::kSplit, 2, 1e-7)});
  EXPECT_EQ(made.scheme, Scheme::kSplit) << made.reason;
  EXPECT_EQ(made.threads, 2);
  EXPECT_EQ(made.reason,
            "split on 2 threads: 2.00 times as fast as serial, the median of 3 alternating trials (2.00 to 2.00)");
  // Samples cut the steps of a trial unevenly: 1 % of them.
  EXPECT_NEAR(made.candidates[0].measured, 2e-7, 0.02 * 2e-7);
  EXPECT_NEAR(made.candidates[1].measured, 1e-7, 0.02 * 1e-7);
  EXPECT_NEAR(made.step, 2e-7, 0.02 * 2e-7);
  EXPECT_GT(made.calibration, 0.0);
  EXPECT_LE(made.calibration, 0.06 * 1.1);  // the last trial may end a sample late
}

TEST(Choose, StaysWithTheFirstWayWhereTheOtherIsSlowerOrHardlyFaster) {
  for (const double other : {1.5e-7, 1e-7, 0.98e-7}) {
    LongRun run;
    const Decision made = chooseWay(
        run.problem, {run.clock.pacedWay(Scheme::kSerial, 1, 1e-7), run.clock.pacedWay(Scheme::kSplit, 2, other)});
    EXPECT_EQ(made.scheme, Scheme::kSerial) << made.reason;
    EXPECT_TRUE(made.reason.starts_with("serial: the best other, split on 2 threads, is ")) << made.reason;
  }
}

// A stranger on the machine slows some trials down, of either way: the median does not see it.
TEST(Choose, TrialsThatSomethingElseDisturbsDoNotDecide) {
  for (const bool disturbs_first : {true, false}) {
    LongRun run;
    int calls = 0;
    const auto steady = [] { return 1e-7; };
    const auto erratic = [&calls] { return ++calls % 4 == 0 ? 9e-7 : 1.05e-7; };
    const auto paced = [&](Scheme scheme, int threads, bool is_disturbed) {
      return is_disturbed ? run.clock.pacedWay(scheme, threads, erratic) : run.clock.pacedWay(scheme, threads, steady);
    };
    const Decision made =
        chooseWay(run.problem, {paced(Scheme::kSerial, 1, disturbs_first), paced(Scheme::kSplit, 2, !disturbs_first)});
    EXPECT_EQ(made.scheme, disturbs_first ? Scheme::kSplit : Scheme::kSerial) << made.reason;
    EXPECT_NE(made.reason.find(" alternating trials ("), std::string::npos) << made.reason;
  }
}

// pipeline shares the input alone, and there is next to none: the rule of thumb spares its trial.
TEST(Choose, AWayThatCannotWinIsNotTried) {
  LongRun run;
  int trials = 0;
  const Way never = {Scheme::kPipeline, 2, [&](const Input&, const Schedule&, const Observer&) { ++trials; }};
  const Decision made = chooseWay(run.problem, {run.clock.pacedWay(Scheme::kSerial, 1, 1e-7), never});
  EXPECT_EQ(made.scheme, Scheme::kSerial);
  EXPECT_EQ(made.reason, "serial: no other scheme can be faster, exchanges included");
  EXPECT_EQ(trials, 0);
}

}  // namespace
}  // namespace vehicle::test
