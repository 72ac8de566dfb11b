// The solvers that share equations among threads give the bits of the serial run: every scheme, map and number of
// threads, on breakpoints, under delays, stopped early and gone infinite.
#include <cmath>

#include "libvehicle/integrate/run.h"
#include "libvehicle/partition/map/equation_map.h"
#include "libvehicle/partition/schemes/blocked_rk4.h"
#include "tests/support/delays.h"
#include "tests/support/mass_graph.h"
#include "tests/support/recorded_run.h"
#include "tests/support/watchdog.h"

namespace vehicle::test {
namespace {

constexpr FixedStep kStep{.step = 1.1e-3, .refine = 1};  // five of them in an output step of 5 ms
constexpr double kOutput = 5e-3;

struct Problem {
  MassGraph system;
  Input input;
  Schedule schedule;
  std::vector<double> start;

  explicit Problem(MassGraph graph, double output_step = kOutput)
      : system(std::move(graph)), input(wavesWithBreakpoints(system.channels())), schedule(input, output_step) {
    for (std::size_t i = 0; i < system.states().size(); ++i) start.push_back(1e-3 * std::sin(1.0 + 2.0 * double(i)));
  }

  RecordedRun serial(int last = -1) const {
    return record(
        [&](const Observer& observe) {
          return runRk4({system, input, schedule, start}, kStep, observe);
        },
        last);
  }
  [[nodiscard]] RunProblem problem() const { return {system, input, schedule, start}; }
  RecordedRun shared(const Sharing& sharing, int last = -1, const TeamPolicy& team = {}) const {
    return record(
        [&](const Observer& observe) { return runPartitioned(problem(), kStep, observe, sharing, team).statistics; },
        last);
  }
};

constexpr Scheme kAll[] = {Scheme::kStages, Scheme::kHalo};

void expectSerialBits(const Problem& problem, Scheme scheme, EquationMap map, int threads,
                      std::function<void(int, long)> injectDelay = {}) {
  SCOPED_TRACE(std::string(nameOf(scheme)) + " " + nameOf(map) + " " + std::to_string(threads));
  const Watchdog watchdog;
  TeamPolicy team;
  team.injectDelay = std::move(injectDelay);
  expectSameBits(problem.shared({threads, scheme, map}, -1, team), problem.serial());
}

TEST(PartitionSolvers, EveryThreadCountGivesTheBitsOfTheSerialRunOnAVehicleShape) {
  const Problem problem(massVehicle());
  for (const Scheme scheme : kAll) {
    for (int threads = 1; threads <= 4; ++threads) expectSerialBits(problem, scheme, EquationMap::kAuto, threads);
    for (int threads = 1; threads <= 2; ++threads) expectSerialBits(problem, scheme, EquationMap::kBody, threads);
  }
}

TEST(PartitionSolvers, EveryThreadCountGivesTheBitsOfTheSerialRunOnAChain) {
  const Problem problem(massChain(17, 2));
  for (const Scheme scheme : kAll) {
    for (const int threads : {1, 2, 3, 5, 8, 13, 16, 17}) {
      expectSerialBits(problem, scheme, EquationMap::kAuto, threads);
    }
    for (const int threads : {1, 4, 9}) expectSerialBits(problem, scheme, EquationMap::kBody, threads);
  }
}

TEST(PartitionSolvers, EveryThreadCountGivesTheBitsOfTheSerialRunOnARing) {
  const Problem problem(massRing(9));
  for (const Scheme scheme : kAll) {
    for (int threads = 1; threads <= 9; ++threads) expectSerialBits(problem, scheme, EquationMap::kAuto, threads);
  }
}

// Runs longer than a cache block, whose window slides; and runs shorter than the halo, which then spans threads.
TEST(PartitionSolvers, RunsLongerThanACacheBlockGiveTheBitsOfTheSerialRun) {
  const Problem problem(massChain(3 * BlockedRk4::kBlock), 0.6);
  for (const int threads : {1, 2}) expectSerialBits(problem, Scheme::kHalo, EquationMap::kAuto, threads);
}

TEST(PartitionSolvers, LongChainsGiveTheBitsOfTheSerialRunForOneToSixteenThreads) {
  const Problem problem(massChain(90, 3));
  for (const int threads : {1, 2, 3, 4, 7, 16}) {
    expectSerialBits(problem, Scheme::kHalo, EquationMap::kAuto, threads);
    expectSerialBits(problem, Scheme::kStages, EquationMap::kAuto, threads);
  }
}

TEST(PartitionSolvers, GiveTheBitsOfTheSerialRunUnderRandomDelays) {
  const Problem vehicle(massVehicle());
  const Problem chain(massChain(12, 2));
  for (const Scheme scheme : kAll) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      expectSerialBits(vehicle, scheme, EquationMap::kAuto, 2, randomDelays(seed));
      expectSerialBits(vehicle, scheme, EquationMap::kAuto, 4, randomDelays(seed + 100));
      expectSerialBits(chain, scheme, EquationMap::kAuto, 3, randomDelays(seed + 200));
    }
  }
}

TEST(PartitionSolvers, AnObserverThatStopsEndsTheRunWhereTheSerialOneEnds) {
  const Problem problem(massChain(8));
  for (const Scheme scheme : kAll) {
    for (const int threads : {1, 2, 3, 8}) {
      for (const int last : {0, 1, 7, 64}) {
        SCOPED_TRACE(std::string(nameOf(scheme)) + " " + std::to_string(threads) + " threads, sample " +
                     std::to_string(last));
        const Watchdog watchdog;
        expectSameBits(problem.shared({threads, scheme}, last), problem.serial(last));
      }
    }
  }
}

// 400 -> 3e8 1/s^2 is far outside the stability of a step of 1 ms; the serial run names a state and a time.
TEST(PartitionSolvers, AStateThatBecomesInfiniteFailsAsTheSerialRunDoes) {
  const Problem problem(massChain(8, 1, 3e8));
  const RecordedRun serial = problem.serial();
  ASSERT_NE(serial.failure.find("is no longer finite"), std::string::npos) << serial.failure;
  for (const Scheme scheme : {Scheme::kSerial, Scheme::kStages, Scheme::kHalo}) {
    for (const int threads : {1, 2, 5, 8}) {
      if (scheme == Scheme::kSerial && threads > 1) continue;
      SCOPED_TRACE(std::string(nameOf(scheme)) + " " + std::to_string(threads));
      const Watchdog watchdog;
      expectSameBits(problem.shared({threads, scheme}), serial);
    }
  }
}

// Whatever the scheme, the entry is one.
TEST(PartitionSolvers, ThePipelineIsReachedBySchemeToo) {
  const Problem problem(massChain(6));
  for (const int threads : {1, 2, 3}) expectSerialBits(problem, Scheme::kPipeline, EquationMap::kAuto, threads);
}

TEST(PartitionSolvers, AnExceptionOfTheObserverReachesTheCaller) {
  const Problem problem(massChain(8));
  for (const Scheme scheme : kAll) {
    const Watchdog watchdog;
    const auto run = [&] {
      return runPartitioned(problem.problem(), kStep,
                            [](int sample, int, double, std::span<const double>) -> bool {
                              if (sample == 9) throw std::domain_error("enough");
                              return true;
                            },
                            {3, scheme});
    };
    EXPECT_THROW(run(), std::domain_error) << nameOf(scheme);
  }
}

TEST(PartitionSolvers, SerialIsTheCacheBlockedCodeOnOneThread) {
  const Problem problem(massChain(90, 3));
  expectSerialBits(problem, Scheme::kSerial, EquationMap::kAuto, 1);
  expectSameBits(record([&](const Observer& observe) {
                   return makeBlockedRk4(problem.problem(), kStep)->run(problem.schedule, problem.start, observe);
                 }),
                 problem.serial());
}

// Samples further apart than a block of steps: the state is looked at between them as well.
TEST(PartitionSolvers, SparseSamplesGiveTheBitsOfTheSerialRun) {
  const Problem problem(massChain(40, 2), 0.4);
  for (const Scheme scheme : kAll) {
    for (const int threads : {1, 2, 4}) expectSerialBits(problem, scheme, EquationMap::kAuto, threads);
  }
}

TEST(PartitionSolvers, AChoiceThatDoesNotFitIsRefusedWithTheReason) {
  const Problem problem(massChain(4));
  const auto refusal = [&](const Sharing& sharing, FixedStep step = kStep) {
    try {
      runPartitioned(
          problem.problem(), step, [](int, int, double, std::span<const double>) { return true; }, sharing);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  EXPECT_EQ(refusal({5, Scheme::kHalo}),
            "5 threads for 4 equations: map auto gives every thread at least one; take at most 4");
  EXPECT_EQ(refusal({2, Scheme::kSerial}), "scheme serial is for 1 thread, here are 2; take stages, halo or pipeline");
  EXPECT_EQ(refusal({2, Scheme::kStages}, {.step = -1.0}),
            "fixed step: step = -1 s, must be finite and > 0; refine = 1, must be >= 1");
}

}  // namespace
}  // namespace vehicle::test
