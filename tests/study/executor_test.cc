#include "libvehicle/study/execute/executor.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <fstream>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "libvehicle/study/execute/work_pool.h"
#include "tests/study/evaluators.h"
#include "tests/support/sanitizers.h"
#include "tests/support/watchdog.h"

namespace vehicle {
namespace {

using test::FunctionEvaluator;
using test::Watchdog;
using namespace std::chrono_literals;

/// What came to the sink: each design's row, and a count that shows a design handed out twice.
struct Table {
  std::map<std::int64_t, std::vector<std::uint64_t>> rows;  // bits: NaN equals itself
  std::map<std::int64_t, std::string> failures;
  int repeated = 0;

  Sink sink(std::size_t columns) {
    return [this, columns](Batch& batch) {
      for (std::int64_t design = batch.range.first; design < batch.range.end; ++design) {
        std::vector<std::uint64_t> bits;
        for (const double value : batch.row(design, columns)) bits.push_back(std::bit_cast<std::uint64_t>(value));
        repeated += rows.emplace(design, bits).second ? 0 : 1;
      }
      for (const DesignFailure& each : batch.failures) failures[each.design] = each.message;
    };
  }
};

void sines(std::int64_t design, std::span<const double>, std::span<double> row) {
  if (design % 97 == 13) throw std::domain_error("design " + std::to_string(design) + " has no mass");
  const auto x = static_cast<double>(design);
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = std::sin(x + 0.1 * static_cast<double>(i));
}

TEST(ThreadExecutor, AnyNumberOfThreadsGivesTheSameTable) {
  const FunctionEvaluator evaluator(3, 7, sines);
  Workload workload;
  workload.ranges = {{0, 500}, {600, 601}, {700, 2000}};
  Table reference;
  ThreadExecutor(1).run(evaluator, workload, reference.sink(3));
  ASSERT_EQ(reference.rows.size(), 1801u);
  ASSERT_EQ(reference.rows.at(600)[1], std::bit_cast<std::uint64_t>(std::sin(600.1)));
  for (const int threads : {2, 3, 5, 8}) {
    Table table;
    EXPECT_EQ(ThreadExecutor(threads).run(evaluator, workload, table.sink(3)), Ending::kFinished);
    EXPECT_EQ(table.rows, reference.rows) << threads << " threads";
    EXPECT_EQ(table.failures, reference.failures);
    EXPECT_EQ(table.repeated, 0);
  }
}

// Room for some threads' stacks and not for all: those that stand already must not be waited for.
TEST(ThreadExecutor, AThreadThatTheSystemRefusesIsAnErrorAndNoHang) {
#ifdef VEHICLE_SANITIZED
  GTEST_SKIP() << "the sanitizers reserve terabytes of addresses";
#endif
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    ::alarm(600);  // a hang must end
    long pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t room = static_cast<rlim_t>(pages) * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + (100u << 20);
    const rlimit limit{room, room};
    if (::setrlimit(RLIMIT_AS, &limit) != 0) ::_exit(2);
    try {
      Table table;
      ThreadExecutor(200).run(FunctionEvaluator(3, 7, sines), {{{0, 100}}, {}}, table.sink(3));
      ::_exit(1);
    } catch (const std::exception&) {
      ::_exit(0);
    }
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status)) << "ended by the alarm";
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(ThreadExecutor, AFailedDesignIsReportedAlone) {
  const FunctionEvaluator evaluator(2, 10, sines);
  Table table;
  ThreadExecutor(2).run(evaluator, {{{0, 100}}, {}}, table.sink(2));
  EXPECT_EQ(table.failures, (std::map<std::int64_t, std::string>{{13, "design 13 has no mass"}}));
  EXPECT_EQ(table.rows.size(), 100u);
  EXPECT_EQ(table.rows.at(12)[0], std::bit_cast<std::uint64_t>(std::sin(12.0)));
}

TEST(ThreadExecutor, GivenNumbersFollowTheirDesigns) {
  // Two numbers a design, ranges with a gap: the row must show the design's own pair wherever the work was cut.
  const FunctionEvaluator evaluator(
      2, 3,
      [](std::int64_t, std::span<const double> given, std::span<double> row) { std::ranges::copy(given, row.begin()); },
      2);
  Workload workload;
  workload.ranges = {{5, 50}, {80, 100}};
  for (const DesignSpan& range : workload.ranges) {
    for (std::int64_t i = range.first; i < range.end; ++i) {
      workload.given.push_back(static_cast<double>(i));
      workload.given.push_back(-static_cast<double>(i));
    }
  }
  Table table;
  ThreadExecutor(3).run(evaluator, workload, table.sink(2));
  ASSERT_EQ(table.rows.size(), 65u);
  for (const auto& [design, bits] : table.rows) {
    EXPECT_EQ(std::bit_cast<double>(bits[0]), static_cast<double>(design));
    EXPECT_EQ(std::bit_cast<double>(bits[1]), -static_cast<double>(design));
  }
}

TEST(ThreadExecutor, StopsOnRequestAndKeepsWhatIsFinished) {
  std::atomic<int> evaluated = 0;
  const FunctionEvaluator evaluator(1, 1, [&](std::int64_t design, std::span<const double>, std::span<double> row) {
    row[0] = static_cast<double>(design);
    ++evaluated;
  });
  Table table;
  const Ending ending = ThreadExecutor(2).run(evaluator, {{{0, 1'000'000}}, {}}, table.sink(1),
                                              [&] { return table.rows.size() < 50; });
  EXPECT_EQ(ending, Ending::kStopped);
  EXPECT_GE(table.rows.size(), 50u);
  EXPECT_EQ(static_cast<int>(table.rows.size()), evaluated);  // what was begun was finished and handed over
  EXPECT_LT(table.rows.size(), 1'000'000u);
}

TEST(ThreadExecutor, IsAskedWhetherToGoOnWhileASlowBatchRuns) {
  // The batch ends when it has been asked often enough: if nobody asks, the watchdog ends the test.
  const Watchdog watchdog;
  std::atomic<int> asked = 0;
  const FunctionEvaluator evaluator(1, 1, [&](std::int64_t, std::span<const double>, std::span<double> row) {
    while (asked < 3) std::this_thread::sleep_for(1ms);
    row[0] = 0.0;
  });
  Table table;
  ThreadExecutor(1).run(evaluator, {{{0, 1}}, {}}, table.sink(1), [&] { return ++asked > 0; });
  EXPECT_GE(asked, 3);
}

TEST(ThreadExecutor, AnErrorThatIsNoDesignsEndsTheRunWithWhatIsFinished) {
  const FunctionEvaluator evaluator(1, 1, [](std::int64_t design, std::span<const double>, std::span<double> row) {
    if (design == 40) throw std::bad_alloc();
    row[0] = 0.0;
  });
  for (const int threads : {1, 3}) {
    Table table;
    ThreadExecutor executor(threads);
    EXPECT_THROW(executor.run(evaluator, {{{0, 100'000}}, {}}, table.sink(1)), std::bad_alloc) << threads;
    EXPECT_EQ(table.rows.count(40), 0u);
    if (threads == 1) {
      EXPECT_EQ(table.rows.size(), 40u);
    }
  }
}

TEST(ThreadExecutor, AWorkerThatCannotBeMadeEndsTheRun) {
  struct Broken : FunctionEvaluator {
    using FunctionEvaluator::FunctionEvaluator;
    std::unique_ptr<Worker> worker() const override { throw std::runtime_error("no such vehicle"); }
  };
  const Broken evaluator(1, 1, sines);
  ThreadExecutor executor(2);
  EXPECT_THROW(executor.run(evaluator, {{{0, 1000}}, {}}, [](Batch&) {}), std::runtime_error);
}

TEST(ThreadExecutor, ASinkThatThrowsEndsTheRun) {
  const FunctionEvaluator evaluator(1, 1, sines);
  ThreadExecutor executor(2);
  int batches = 0;
  const Sink full = [&](Batch&) {
    if (++batches == 5) throw std::runtime_error("disk full");
  };
  EXPECT_THROW(executor.run(evaluator, {{{0, 1'000'000}}, {}}, full), std::runtime_error);
  EXPECT_EQ(batches, 5);
}

TEST(ThreadExecutor, WaitsWhenTheSinkIsSlow) {
  // Memory: without a bound all 300 batches would be finished long before the sink has taken the tenth.
  std::atomic<int> evaluated = 0;
  const FunctionEvaluator evaluator(1, 1, [&](std::int64_t, std::span<const double>, std::span<double> row) {
    ++evaluated;
    row[0] = 0.0;
  });
  int taken = 0;
  int most_ahead = 0;
  ThreadExecutor(2).run(evaluator, {{{0, 300}}, {}}, [&](Batch&) {
    if (taken < 30) std::this_thread::sleep_for(1ms);
    ++taken;
    most_ahead = std::max(most_ahead, evaluated - taken);
  });
  EXPECT_EQ(taken, 300);
  EXPECT_LE(most_ahead, 2 * 2 + 2 + 2);  // the queue, and one batch in the hands of each thread
}

TEST(ThreadExecutor, UnevenWorkIsShared) {
  // A quarter of the designs each. Once all threads have begun, the first design takes until another thread evaluates
  // one of its own quarter: threads that are through must take from whoever has work, or the watchdog ends the test.
  const Watchdog watchdog;
  constexpr int kThreads = 4;
  std::atomic<int> begun = 0;
  std::atomic<bool> has_help = false;
  const FunctionEvaluator evaluator(1, 1, [&](std::int64_t design, std::span<const double>, std::span<double> row) {
    thread_local bool is_first_of_thread = true;
    thread_local bool has_design_0 = false;
    has_design_0 = has_design_0 || design == 0;
    if (std::exchange(is_first_of_thread, false)) {
      for (++begun; begun < kThreads;) std::this_thread::sleep_for(100us);
    }
    if (design < 100 && !has_design_0) has_help = true;
    while (design == 0 && !has_help) std::this_thread::sleep_for(100us);
    row[0] = 0.0;
  });
  ThreadExecutor(kThreads).run(evaluator, {{{0, 400}}, {}}, [](Batch&) {});
  EXPECT_TRUE(has_help);
}

TEST(ThreadExecutor, NoWorkIsDoneAtOnce) {
  const FunctionEvaluator evaluator(1, 1, sines);
  int batches = 0;
  EXPECT_EQ(ThreadExecutor(2).run(evaluator, {}, [&](Batch&) { ++batches; }), Ending::kFinished);
  EXPECT_EQ(batches, 0);
}

TEST(ThreadExecutor, RefusesWhatDoesNotFit) {
  const FunctionEvaluator evaluator(1, 1, sines, 2);
  ThreadExecutor executor(1);
  const auto run = [&](const Workload& workload) { executor.run(evaluator, workload, [](Batch&) {}); };
  EXPECT_THROW(run({{{0, 3}}, {1.0, 2.0}}), std::invalid_argument);
  EXPECT_THROW(run({{{0, 0}}, {}}), std::invalid_argument);
  EXPECT_THROW(run({{{0, 2}, {1, 3}}, std::vector<double>(8)}), std::invalid_argument);
  EXPECT_THROW(ThreadExecutor(-1), std::invalid_argument);
  EXPECT_GE(ThreadExecutor(0).threads(), 1);
}

TEST(WorkPool, GoesOnWithWorkThatIsAddedLater) {
  const FunctionEvaluator evaluator(1, 4, sines);
  WorkPool pool(evaluator, 2);
  std::int64_t taken = 0;
  for (int round = 0; round < 200; ++round) {
    const std::vector<DesignSpan> ranges = {{10 * round, 10 * round + 10}};
    pool.add(ranges, {});
    while (pool.outstanding() > 0) {
      if (auto batch = pool.take(1s)) taken += batch->range.size();
    }
  }
  EXPECT_EQ(taken, 2000);
}

TEST(WorkPool, AbandonedWorkLeavesThePoolUsable) {
  const FunctionEvaluator evaluator(1, 1, [](std::int64_t, std::span<const double>, std::span<double> row) {
    std::this_thread::sleep_for(100us);
    row[0] = 1.0;
  });
  WorkPool pool(evaluator, 3);
  for (int round = 0; round < 5; ++round) {
    const std::vector<DesignSpan> many = {{0, 1'000'000'000}};
    pool.add(many, {});
    while (!pool.take(1s)) continue;
    pool.abandon();
    while (pool.outstanding() > 0) pool.take(1s);
  }
  const std::vector<DesignSpan> few = {{0, 20}};
  pool.add(few, {});
  std::int64_t taken = 0;
  while (pool.outstanding() > 0) {
    if (auto batch = pool.take(1s)) taken += batch->range.size();
  }
  EXPECT_EQ(taken, 20);
}

}  // namespace
}  // namespace vehicle
