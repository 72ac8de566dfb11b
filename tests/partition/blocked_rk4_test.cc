// The step as one pass through the cache: any block length, any run of wanted equations, no allocation.
#include "libvehicle/partition/schemes/blocked_rk4.h"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "libvehicle/integrate/rk4.h"
#include "libvehicle/integrate/run.h"
#include "libvehicle/partition/map/cut_order.h"
#include "tests/support/allocations.h"
#include "tests/support/mass_graph.h"

namespace vehicle::test {
namespace {

constexpr FixedStep kStep{.step = 1e-3, .refine = 1};

std::vector<double> startOf(const System& system) {
  std::vector<double> start;
  for (std::size_t i = 0; i < system.states().size(); ++i) start.push_back(1e-3 * std::cos(2.0 + 3.0 * double(i)));
  return start;
}

struct Problem {
  MassGraph system;
  Input input;
  Schedule schedule;
  std::vector<double> start;
  CutRun cut;
  EquationGraph graph;

  explicit Problem(MassGraph masses)
      : system(std::move(masses)),
        input(wavesWithBreakpoints(system.channels())),
        schedule(input, 0.3),
        start(startOf(system)),
        cut({system, input, schedule, start}),
        graph(cut.set()) {}

  std::vector<double> serialEnd() const {
    std::vector<double> end;
    runRk4({system, input, schedule, start}, kStep, [&](int, int, double, std::span<const double> x) {
      end.assign(x.begin(), x.end());
      return true;
    });
    return end;
  }

  std::vector<double> blockedEnd(int block) const {
    BlockedRk4 rk4(cut.set(), graph, cut.input(), {0, graph.size()}, block);
    std::copy(cut.x0().begin(), cut.x0().end(), rk4.x());
    walkSteps(
        {schedule, kStep, rk4.stepsOfBlock()}, [&](const StepBlock& steps) { rk4.enter(steps); },
        [&](double h, int k) {
          rk4.prepare(k);
          rk4.step(h, k, [](int) {});
        },
        [](const StepPause&) { return true; });
    std::vector<double> end(start.size());
    for (std::size_t i = 0; i < end.size(); ++i) end[static_cast<std::size_t>(cut.set().stateOrder()[i])] = rk4.x()[i];
    return end;
  }
};

// 8 channels are swept whole, 26 are read row by row.
TEST(BlockedRk4, EveryBlockLengthGivesTheBitsOfTheSerialRun) {
  for (const MassGraph& graph : {massChain(15, 2), massChain(52, 1), massChain(51, 3), massRing(18), massVehicle()}) {
    const Problem problem(graph);
    const std::vector<double> serial = problem.serialEnd();
    for (const int block : {1, 2, 3, 5, 8, 13, 40, 1000}) {
      EXPECT_EQ(problem.blockedEnd(block), serial) << graph.states().size() / 2 << " masses, block " << block;
    }
  }
}

// A halo's worth of the state before a step is all that the new state of some equations needs.
TEST(BlockedRk4, TheStateHeldSufficesForTheTarget) {
  const Problem problem(massChain(52, 2));
  const StepBlock steps{.segment = 0, .begin = 0.0, .h = 1e-3, .first = 0, .last = 1};
  BlockedRk4 whole(problem.cut.set(), problem.graph, problem.cut.input(), {0, 52}, 7);
  std::copy(problem.cut.x0().begin(), problem.cut.x0().end(), whole.x());
  whole.enter(steps);
  whole.prepare(0);
  whole.step(steps.h, 0, [](int) {});
  for (const EquationRun target : {EquationRun{0, 3}, EquationRun{20, 31}, EquationRun{51, 52}}) {
    for (const int block : {1, 4, 100}) {
      BlockedRk4 part(problem.cut.set(), problem.graph, problem.cut.input(), target, block);
      EXPECT_EQ(part.held(), (EquationRun{std::max(0, target.first - 8), std::min(52, target.last + 8)}));
      std::copy_n(problem.cut.x0().begin() + 2 * part.held().first, 2 * part.held().size(), part.x());
      part.enter(steps);
      part.prepare(0);
      part.step(steps.h, 0, [](int) {});
      EXPECT_EQ(std::memcmp(part.x(target.first), whole.x(target.first), 2 * sizeof(double) *
                            static_cast<std::size_t>(target.size())), 0)
          << target.first << " block " << block;
    }
  }
}

// A thread looks for a neighbour's state before the first block that reads it, and not later.
TEST(BlockedRk4, TheFirstBlockReadingIsToldForEveryEquation) {
  const Problem problem(massChain(52, 1));
  const BlockedRk4 rk4(problem.cut.set(), problem.graph, problem.cut.input(), {10, 40}, 5);
  EXPECT_EQ(rk4.held(), (EquationRun{6, 44}));
  EXPECT_EQ(rk4.firstBlockReading(6), 0);
  EXPECT_EQ(rk4.firstBlockReading(12), 0);  // stage 1 of the block 7..11 reads up to 12
  EXPECT_EQ(rk4.firstBlockReading(13), 1);
  EXPECT_EQ(rk4.firstBlockReading(44), rk4.blocks());
}

TEST(BlockedRk4, AStepNeverAllocates) {
  for (const MassGraph& graph : {massChain(15, 2), massChain(52, 1)}) {
    const Problem problem(graph);
    BlockedRk4 rk4(problem.cut.set(), problem.graph, problem.cut.input(), {0, problem.graph.size()}, 8);
    const StepBlock steps{.segment = 2, .begin = 0.3, .h = 1e-3, .first = 0, .last = rk4.stepsOfBlock()};
    rk4.enter(steps);
    const long before = allocations();
    rk4.enter(steps);
    for (int k = 0; k < steps.last; ++k) {
      rk4.prepare(k);
      rk4.step(steps.h, k, [](int) {});
    }
    EXPECT_EQ(allocations(), before);
  }
}

TEST(BlockedRk4, ATargetThatIsNotThereIsRefused) {
  const Problem problem(massChain(5));
  const auto build = [&](EquationRun target, int block) {
    BlockedRk4 rk4(problem.cut.set(), problem.graph, problem.cut.input(), target, block);
  };
  EXPECT_THROW(build({0, 6}, 8), std::invalid_argument);
  EXPECT_THROW(build({3, 3}, 8), std::invalid_argument);
  EXPECT_THROW(build({0, 5}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace vehicle::test
