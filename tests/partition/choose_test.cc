#include "libvehicle/partition/choose.h"

#include <sys/resource.h>

#include <chrono>
#include <optional>
#include <thread>

#include <gtest/gtest.h>

#include "libvehicle/integrate/fixed_step_run.h"
#include "tests/support/paper_matrices.h"

namespace vehicle::test {
namespace {

/// A system that is asked for its size alone: eight states, no equations to share.
class EightStates final : public System {
 public:
  int channels() const override { return 4; }
  const std::vector<Channel>& states() const override { return states_; }
  const std::vector<Channel>& outputs() const override { return states_; }
  void derivative(std::span<const double>, std::span<const double>, std::span<double>) const override {}
  void output(std::span<const double>, std::span<const double>, std::span<double>) const override {}

 private:
  std::vector<Channel> states_ = paperStates();
};

/// Walks through the schedule and takes that long a step [s], by a busy clock.
Way pacedWay(Scheme scheme, int threads, std::function<double()> step_time) {
  return {scheme, threads, [step_time](const Input&, const Schedule& schedule, const Observer& observe) {
            const std::vector<double> x(8, 0.0);
            observe(0, 0, 0.0, x);
            const double step = step_time();
            for (const Stretch stretch : schedule.stretches()) {
              const auto begin = std::chrono::steady_clock::now();
              const double seconds = step * stepsOf(stretch.end - stretch.begin, {1e-3});
              while (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() < seconds) {
              }
              if (stretch.sample >= 0) observe(stretch.sample, stretch.next, stretch.end, x);
            }
          }};
}
Way pacedWay(Scheme scheme, int threads, double step_time) {
  return pacedWay(scheme, threads, [step_time] { return step_time; });
}

/// A busy machine lets no timing count: then the answer is the first way, for one of two reasons.
bool isBusy(const Decision& made) {
  return made.reason.find("something else is using the machine") != std::string::npos ||
         made.reason.find("too long to try others") != std::string::npos;
}

/// Decides until a decision fell during which nobody took the core away: on a busy machine timings say nothing about
/// the ways. Nothing if there is no such moment.
template <class Decide>
std::optional<Decision> decisionInPeace(Decide decide) {
  const auto lost = [] {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_nivcsw;
  };
  for (int attempt = 0; attempt < 8; ++attempt) {
    const long before = lost();
    Decision made = decide();
    if (lost() == before) return made;
  }
  return std::nullopt;
}

/// Long enough that a step of a microsecond is worth a calibration.
struct LongRun {
  EightStates system;
  Input input = paperExtended(10000.0);
  Schedule schedule{input, 10000.0};
  TeamChoice team;
  WayProblem problem{.system = system, .input = input, .schedule = schedule,
                     .steps = stepsOfRun(schedule, {1e-3}), .team = team};
};

TEST(Choose, CountsTheStepsOfARun) {
  EXPECT_EQ(LongRun().problem.steps, 10'000'000);
  const Input onset = paperOnset(10.0);
  EXPECT_EQ(stepsOfRun(Schedule(onset, 5e-3), {1e-3}), 10'002);  // two kinks cut a step in halves
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
  const TeamChoice team;
  const Way never = {Scheme::kPipeline, 2, [](const Input&, const Schedule&, const Observer&) { FAIL() << "tried"; }};
  const Decision made = chooseWay({.system = system, .input = input, .schedule = schedule, .steps = 10'000,
                                   .team = team}, {{Scheme::kSerial, 1, never.run}, never});
  EXPECT_EQ(made.scheme, Scheme::kSerial);
  EXPECT_NE(made.reason.find("too short to try others"), std::string::npos) << made.reason;
  EXPECT_EQ(made.candidates.size(), 2u);
}

TEST(Choose, TakesTheWayThatIsFasterAndSaysByHowMuch) {
  const LongRun run;
  const std::optional<Decision> made = decisionInPeace([&] {
    return chooseWay(run.problem, {pacedWay(Scheme::kSerial, 1, 2e-6), pacedWay(Scheme::kSplit, 2, 1e-6)});
  });
  if (!made || isBusy(*made)) GTEST_SKIP() << "something else is using the machine";
  EXPECT_EQ(made->scheme, Scheme::kSplit) << made->reason;
  EXPECT_EQ(made->threads, 2);
  EXPECT_LT(made->candidates[1].measured, made->candidates[0].measured);
  EXPECT_GT(made->calibration, 0.0);
  EXPECT_GT(made->step, 1.9e-6);
}

TEST(Choose, StaysWithTheFirstWayWhereTheOtherIsSlower) {
  const LongRun run;
  const std::optional<Decision> made = decisionInPeace([&] {
    return chooseWay(run.problem, {pacedWay(Scheme::kSerial, 1, 1e-6), pacedWay(Scheme::kSplit, 2, 1.5e-6)});
  });
  if (!made || isBusy(*made)) GTEST_SKIP() << "something else is using the machine";
  EXPECT_EQ(made->scheme, Scheme::kSerial) << made->reason;
}

TEST(Choose, StaysWithTheFirstWayWhereTimingsDoNotRepeat) {
  const LongRun run;
  const std::optional<Decision> made = decisionInPeace([&] {
    int calls = 0;
    const auto erratic = [&calls] { return ++calls % 2 == 0 ? 1e-6 : 4e-6; };
    return chooseWay(run.problem, {pacedWay(Scheme::kSerial, 1, erratic), pacedWay(Scheme::kSplit, 2, 0.3e-6)});
  });
  if (!made) GTEST_SKIP() << "something else is using the machine";
  EXPECT_EQ(made->scheme, Scheme::kSerial) << made->reason;
  EXPECT_TRUE(isBusy(*made)) << made->reason;
}

// An exact method of a large system finds its matrices for 20 ms before each trial: two trials would be the whole
// calibration.
TEST(Choose, StaysWithTheFirstWayWhereATrialIsSlowToStart) {
  const LongRun run;
  const Way paced = pacedWay(Scheme::kSerial, 1, 1e-6);
  int trials = 0;
  const Way slow = {Scheme::kSerial, 1, [&](const Input& input, const Schedule& schedule, const Observer& observe) {
                      ++trials;
                      std::this_thread::sleep_for(std::chrono::milliseconds(20));
                      paced.run(input, schedule, observe);
                    }};
  const Decision made = chooseWay(run.problem, {slow, pacedWay(Scheme::kRows, 2, 0.1e-6)});
  EXPECT_EQ(made.scheme, Scheme::kSerial);
  EXPECT_NE(made.reason.find("too long to try others"), std::string::npos) << made.reason;
  EXPECT_EQ(trials, 1);
}

}  // namespace
}  // namespace vehicle::test
