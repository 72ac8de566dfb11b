#include "libvehicle/partition/schemes/pipeline.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/integrate/fixed_steps.h"
#include "libvehicle/integrate/rk4.h"
#include "tests/support/eight_states.h"
#include "tests/support/paper_matrices.h"
#include "tests/support/tolerance.h"
#include "tests/support/watchdog.h"

namespace vehicle::test {
namespace {

/// The paper's vehicle as matrices.
struct PaperRhs {
  StateSpace matrices = paperMatrices();
  void operator()(const double* x, const double* u, double* dx) const {
    Eigen::Map<Eigen::Vector<double, 8>> slope(dx);
    slope.noalias() = matrices.A * Eigen::Map<const Eigen::Vector<double, 8>>(x);
    slope.noalias() += matrices.B * Eigen::Map<const Eigen::Vector<double, 8>>(u);
  }
};

const std::vector<double> kRest(8, 0.0);

/// The paper's rail stored every 3 ms: more than a thousand segments of a few steps each.
Input storedRail() {
  std::vector<double> height, rate, u(8);
  const Input rail = paperExtended(4.1);
  for (int i = 0; i <= 1333; ++i) {
    rail.evaluate(0, 3e-3 * i, u);
    height.insert(height.end(), u.begin(), u.begin() + 4);
    rate.insert(rate.end(), u.begin() + 4, u.end());
  }
  return storedInput(4, 0.0, 3e-3, height, rate);
}

struct Met {
  std::vector<double> rows;
  Statistics statistics;
  AheadCounts input;
  std::size_t team = 0;
};

Observer writeTo(Met& met) {
  return [&met, expected = 0](int sample, int segment, double t, std::span<const double> x) mutable {
    EXPECT_EQ(sample, expected++);
    met.rows.insert(met.rows.end(), {static_cast<double>(segment), t});
    met.rows.insert(met.rows.end(), x.begin(), x.end());
    return true;
  };
}

Met serial(const Input& input, const Schedule& schedule, FixedStep step) {
  Met met;
  Rk4<PaperRhs, 8> stepper(PaperRhs{});
  met.statistics = FixedSteps(stepper, input, step).run(schedule, kRest, writeTo(met));
  return met;
}

Met pipelined(const Input& input, const Schedule& schedule, FixedStep step, int threads, const TeamPolicy& team = {}) {
  Met met;
  Rk4<PaperRhs, 8> stepper(PaperRhs{});
  const EightStates system;
  PipelineRun made =
      runPipelined(stepper, {system, input, schedule, kRest}, {step, sweepRows(input), threads}, writeTo(met), team);
  met.statistics = made.run.statistics;
  met.input = made.input;
  met.team = made.run.team.members.size();
  return met;
}

TEST(Pipeline, EveryNumberOfThreadsGivesTheBitsOfTheSerialRun) {
  for (const Input& input : {paperOnset(4.0), paperExtended(4.0), storedRail()}) {
    for (const double output_step : {5e-3, 0.7}) {
      const Schedule schedule(input, output_step);
      const FixedStep step{1e-3, 1};
      const Met expected = serial(input, schedule, step);
      for (const int threads : {1, 2, 3, 4, 7}) {
        const Met met = pipelined(input, schedule, step, threads);
        EXPECT_EQ(met.rows, expected.rows) << threads << " threads, samples every " << output_step << " s";
        EXPECT_EQ(met.statistics.steps, expected.statistics.steps);
        EXPECT_EQ(met.statistics.evaluations, expected.statistics.evaluations);
        EXPECT_EQ(met.team, static_cast<std::size_t>(threads));
      }
    }
  }
}

/// Sleeps now and then, long enough for a claimed parcel to be computed again.
TeamPolicy delayed(int threads, int longest_us, unsigned seed) {
  TeamPolicy team;
  auto generators = std::make_shared<std::vector<std::minstd_rand>>();
  for (int i = 0; i < threads; ++i) generators->emplace_back(seed + 17u * static_cast<unsigned>(i));
  team.injectDelay = [generators, longest_us](int thread, long) {
    auto& draw = (*generators)[static_cast<std::size_t>(thread)];
    draw();
    if (draw() % 5 != 0) return;
    std::this_thread::sleep_for(std::chrono::microseconds(draw() % static_cast<unsigned>(longest_us)));
  };
  return team;
}

TEST(Pipeline, RandomDelaysAtEveryClaimChangeNoBit) {
  const Input onset = paperOnset(3.0);
  const Input stored = storedRail();
  for (const Input* input : {&onset, &stored}) {
    const Schedule schedule(*input, 5e-3);
    const FixedStep step{1e-3, 4};
    const Met expected = serial(*input, schedule, step);
    for (const int threads : {2, 3, 4}) {
      for (const int longest_us : {50, 1500}) {
        const Met met = pipelined(*input, schedule, step, threads, delayed(threads, longest_us, 5));
        EXPECT_EQ(met.rows, expected.rows) << threads << " threads, delays up to " << longest_us << " us";
      }
    }
  }
}

TEST(Pipeline, AHelperThatDoesNotComeBackIsNotWaitedFor) {
  const Input input = paperOnset(2.0);
  const Schedule schedule(input, 5e-3);
  const FixedStep step{1e-3, 4};
  const Met expected = serial(input, schedule, step);
  TeamPolicy team;
  // Member 0 begins when the helper has claimed a parcel, and the helper comes back when member 0 has passed it: that
  // looks ahead by less than all slots.
  const Watchdog watchdog;
  std::atomic<long> claimed{-1}, reached{-1};
  team.injectDelay = [&](int thread, long parcel) {
    if (thread == 0) {
      reached = std::max(reached.load(), parcel);
      while (claimed < 0) std::this_thread::yield();
      return;
    }
    long none = -1;
    if (!claimed.compare_exchange_strong(none, parcel)) return;
    while (reached < parcel + InputAhead::kMostSlots) std::this_thread::yield();
  };
  const Met met = pipelined(input, schedule, step, 2, team);
  EXPECT_EQ(met.rows, expected.rows);
  EXPECT_GT(met.input.redone, 0);
  EXPECT_GE(met.input.own, met.input.redone);
}

TEST(Pipeline, EveryParcelIsCountedOnce) {
  const Input input = paperOnset(4.0);
  const Schedule schedule(input, 4.0);
  const InputParcels parcels(schedule, {1e-3});
  for (const int threads : {1, 3}) {
    const Met met = pipelined(input, schedule, {1e-3}, threads);
    EXPECT_EQ(met.input.taken + met.input.own, parcels.count());
    EXPECT_TRUE(threads > 1 || met.input.taken == 0);
  }
}

TEST(InputParcels, HoldEveryBlockOfTheRunInOrder) {
  for (const Input& input : {paperOnset(4.0), storedRail()}) {
    const Schedule schedule(input, 5e-3);
    const FixedStep step{1e-3, 3};
    const InputParcels parcels(schedule, step);
    std::vector<StepBlock> met, some;
    long steps = 0;
    for (long p = 0; p < parcels.count(); ++p) {
      parcels.read(p, some);
      EXPECT_EQ(parcels.stepsOf(p).first, steps);
      for (const StepBlock& block : some) steps += block.last - block.first;
      EXPECT_EQ(parcels.stepsOf(p).last, steps);
      met.insert(met.end(), some.begin(), some.end());
    }
    std::size_t next = 0;
    walkSteps(
        {schedule, step},
        [&](const StepBlock& block) {
          ASSERT_LT(next, met.size());
          EXPECT_EQ(met[next].segment, block.segment);
          EXPECT_EQ(met[next].begin, block.begin);
          EXPECT_EQ(met[next].h, block.h);
          EXPECT_EQ(met[next].first, block.first);
          EXPECT_EQ(met[next].last, block.last);
          ++next;
        },
        [](double, int) {}, [](const StepPause&) { return true; });
    EXPECT_EQ(next, met.size());
    EXPECT_LE(parcels.count(), static_cast<long>(met.size()));
  }
  // A stored rail is handed over by the hundred steps and not segment by segment.
  const Input stored = storedRail();
  EXPECT_LT(InputParcels(Schedule(stored, 5e-3), {1e-3}).count(), 100);
}

TEST(Pipeline, AnObserverThatSaysNoEndsTheTeam) {
  const Input input = paperOnset(10.0);
  const Schedule schedule(input, 5e-3);
  Rk4<PaperRhs, 8> stepper(PaperRhs{});
  for (const int last : {0, 1, 700}) {
    const EightStates system;
    const PipelineRun made =
        runPipelined(stepper, {system, input, schedule, kRest}, {{1e-3}, sweepRows(input), 3},
                     [&](int sample, int, double, std::span<const double>) { return sample < last; }, {});
    EXPECT_TRUE(made.run.statistics.stopped);
    const Statistics alone =
        FixedSteps(stepper, input, {1e-3}).run(schedule, kRest, [&](int sample, int, double, std::span<const double>) {
          return sample < last;
        });
    EXPECT_EQ(made.run.statistics.steps, alone.steps);
  }
}

TEST(Pipeline, AnUnstableStepAndAWrongStartAreToldAsBySerial) {
  const Input input = paperExtended(400.0);
  const Schedule schedule(input, 1.0);
  Rk4<PaperRhs, 8> stepper(PaperRhs{});
  const auto message = [&](auto run) -> std::string {
    try {
      run();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "not refused";
  };
  const EightStates system;
  const Observer watch = [](int, int, double, std::span<const double>) { return true; };
  const std::string alone = message([&] { (void)FixedSteps(stepper, input, {1.0}).run(schedule, kRest, watch); });
  EXPECT_NE(alone.find("is no longer finite"), std::string::npos) << alone;
  EXPECT_EQ(message([&] {
              (void)runPipelined(stepper, {system, input, schedule, kRest}, {{1.0}, sweepRows(input)}, watch, {});
            }),
            alone);
  EXPECT_EQ(message([&] {
              (void)runPipelined(stepper, {system, input, schedule}, {{1e-3}, sweepRows(input)}, watch, {});
            }),
            "rk4: x0 has 0 values, must have 8, one a state");
}

}  // namespace
}  // namespace vehicle::test
