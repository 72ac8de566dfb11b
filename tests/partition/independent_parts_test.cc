#include "libvehicle/partition/schemes/independent_parts.h"

#include <array>
#include <chrono>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/integrate/fixed_steps.h"
#include "libvehicle/integrate/rk4.h"
#include "tests/support/paper_matrices.h"

namespace vehicle::test {
namespace {

/// A mass on spring and damper that follows one channel of the paper's rail.
struct Mass {
  double stiffness, damping;
  int channel;
  void operator()(const double* x, const double* u, double* dx) const {
    dx[0] = x[1];
    dx[1] = -stiffness * (x[0] - u[channel]) - damping * (x[1] - u[4 + channel]);
  }
};

constexpr double kOutput = 2e-3;  // [s] two steps of 1 ms a sample: rings turn often

struct Problem {
  Input input;
  Schedule schedule;
  std::vector<IndependentPart> parts;

  explicit Problem(int masses, double duration = 12.0) : input(paperOnset(duration)), schedule(input, kOutput) {
    for (int i = 0; i < masses; ++i) {
      parts.push_back({2, [this, i](const Observer& observe, Member*) {
                         Rk4<Mass, 2> stepper(Mass{60.0 + 40.0 * i, 3.0 + i, i % 4});
                         return FixedSteps(stepper, input, {1e-3}).run(schedule, std::array{1e-3 * i, 0.0}, observe);
                       }});
    }
  }
};

struct Met {
  std::vector<double> rows;
  Statistics statistics;
  std::size_t team = 0;
};

Met runOn(const Problem& problem, int threads, const TeamPolicy& team = {}) {
  Met met;
  int expected = 0;
  const Observer observe = [&](int sample, int segment, double t, std::span<const double> x) {
    EXPECT_EQ(sample, expected++);
    met.rows.push_back(segment);
    met.rows.push_back(t);
    met.rows.insert(met.rows.end(), x.begin(), x.end());
    return true;
  };
  const PartsRun run = runIndependentParts(problem.parts, problem.schedule.samples(), observe, threads, team);
  met.statistics = run.statistics;
  met.team = run.team.members.size();
  return met;
}

/// The same rows put together by hand from serial runs.
std::vector<double> serialRows(const Problem& problem) {
  std::vector<std::vector<double>> of_part(problem.parts.size());
  std::vector<double> moments;
  for (std::size_t p = 0; p < of_part.size(); ++p) {
    (void)problem.parts[p].run([&](int, int segment, double t, std::span<const double> x) {
      of_part[p].insert(of_part[p].end(), x.begin(), x.end());
      if (p == 0) moments.insert(moments.end(), {static_cast<double>(segment), t});
      return true;
    }, nullptr);
  }
  std::vector<double> rows;
  for (std::size_t i = 0; i < moments.size(); i += 2) {
    rows.insert(rows.end(), {moments[i], moments[i + 1]});
    for (const auto& part : of_part) rows.insert(rows.end(), {part[i], part[i + 1]});
  }
  return rows;
}

TEST(IndependentParts, EveryNumberOfThreadsShowsTheBitsOfTheSerialRuns) {
  const Problem problem(4);
  const std::vector<double> serial = serialRows(problem);
  for (const int threads : {1, 2, 3, 4}) {
    const Met met = runOn(problem, threads);
    EXPECT_EQ(met.rows, serial) << threads << " threads";
    EXPECT_EQ(met.statistics.steps, 12002);  // 12 s of 1 ms; two breakpoints cut a step in halves
    EXPECT_EQ(met.statistics.evaluations, 4 * 4 * met.statistics.steps);
    EXPECT_EQ(met.team, threads == 1 ? 0u : static_cast<std::size_t>(threads));
  }
}

TEST(IndependentParts, RandomDelaysChangeNoBit) {
  const Problem problem(2, 6.0);
  const std::vector<double> serial = serialRows(problem);
  for (const int slow : {0, 1}) {
    TeamPolicy team;
    std::array<std::minstd_rand, 2> generators{std::minstd_rand(7), std::minstd_rand(11)};
    team.injectDelay = [&](int thread, long) {
      auto& draw = generators[static_cast<std::size_t>(thread)];
      if (draw() % (thread == slow ? 40 : 400) != 0) return;
      std::this_thread::sleep_for(std::chrono::microseconds(draw() % 300));
    };
    EXPECT_EQ(runOn(problem, 2, team).rows, serial) << "thread " << slow << " is slow";
  }
}

TEST(IndependentParts, AnObserverThatSaysNoEndsAllOfThem) {
  const Problem problem(2);
  for (const int threads : {1, 2}) {
    int last = -1;
    const PartsRun run = runIndependentParts(
        problem.parts, problem.schedule.samples(),
        [&](int sample, int, double, std::span<const double>) { return (last = sample) < 700; }, threads, {});
    EXPECT_EQ(last, 700) << threads << " threads";
    EXPECT_TRUE(run.statistics.stopped);
  }
}

TEST(IndependentParts, AFailureOfAnyPartReachesTheCaller) {
  for (const std::size_t bad : {0u, 1u}) {
    for (const int threads : {1, 2}) {
      Problem problem(2);
      problem.parts[bad].run = [](const Observer& observe, Member*) -> Statistics {
        for (int sample = 0; sample < 100; ++sample) observe(sample, 0, sample * kOutput, std::array{0.0, 0.0});
        throw std::runtime_error("rk4: state 1 is no longer finite at t = 0.2 s");
      };
      try {
        (void)runOn(problem, threads);
        ADD_FAILURE() << "not noticed";
      } catch (const std::runtime_error& failure) {
        EXPECT_STREQ(failure.what(), "rk4: state 1 is no longer finite at t = 0.2 s");
      }
    }
  }
}

TEST(IndependentParts, APartThatEndsBeforeTheOthersIsToldAndDoesNotHang) {
  for (const int threads : {1, 2}) {
    Problem problem(2);
    problem.parts[1].run = [](const Observer& observe, Member*) {
      for (int sample = 0; sample < 50; ++sample) observe(sample, 0, sample * kOutput, std::array{0.0, 0.0});
      return Statistics{};
    };
    try {
      (void)runOn(problem, threads);
      ADD_FAILURE() << "not noticed";
    } catch (const std::invalid_argument& error) {
      EXPECT_STREQ(error.what(),
                   "independent parts: part 1 has 50 samples, must have the schedule's 6001");
    }
  }
}

TEST(IndependentParts, RefusesMoreThreadsThanPartsAndNoParts) {
  const auto refusal = [](int masses, int threads) -> std::string {
    try {
      (void)runOn(Problem(masses), threads);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "not refused";
  };
  EXPECT_EQ(refusal(2, 3), "independent parts: threads = 3, must be 1..2, one a part at most");
  EXPECT_EQ(refusal(2, 0), "independent parts: threads = 0, must be 1..2, one a part at most");
  EXPECT_EQ(refusal(0, 1), "independent parts: there are none, must be at least one");
}

}  // namespace
}  // namespace vehicle::test
