#pragma once

#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "benchmarks/paper_case.h"

namespace vehicle::bench {

/// Processor time of this thread [s]: what a neighbour on the machine takes away does not count.
inline double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Wall time [s]: what threads cost that wait for each other. Only a quiet machine measures it right.
inline double wallSeconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Registers benchmarks once the command line is read: --threads=2,4 gives the numbers of threads (default 2,4).
using ThreadedRegistration = std::function<void(const std::vector<int>& thread_counts)>;
bool registerForThreads(ThreadedRegistration registration);

/// Times runs of threads. batch() does `steps` of something and returns the wall time [s] it took, start and end of
/// the threads not counted.
template <class Batch>
void measureWall(benchmark::State& state, int threads, long steps, Batch batch) {
  double seconds = 0.0;
  for (auto _ : state) {
    const double took = batch();
    state.SetIterationTime(took);
    seconds += took;
  }
  state.counters["threads"] = threads;
  state.counters["ns_per_step"] = 1e9 * seconds / static_cast<double>(state.iterations()) / static_cast<double>(steps);
}

/// Whether a result misses what its comparison states; says so and ends the benchmark.
inline bool isAnotherProblem(benchmark::State& state, double error, double allowed_error) {
  if (error <= allowed_error) return false;
  const std::string text =
      "error " + std::to_string(1e9 * error) + "e-9 is above what this comparison states: not the same problem";
  state.SkipWithError(text.c_str());
  return true;
}

/// Times solve() (a whole run, giving the state at its end) after checking that it solves the same problem to
/// the error that the comparison states.
/// @param steps  the cost is reported as ns per one of them; 1: ns of a whole run
template <class Solve>
void measure(benchmark::State& state, const PaperCase& problem, double allowed_error, long steps, Solve solve) {
  const double error = problem.errorOf(solve());
  if (isAnotherProblem(state, error, allowed_error)) return;
  double seconds = 0.0;
  for (auto _ : state) {
    const double begin = threadSeconds();
    benchmark::DoNotOptimize(solve());
    const double took = threadSeconds() - begin;
    state.SetIterationTime(took);
    seconds += took;
  }
  state.counters["error"] = error;
  state.counters["ns_per_step"] = 1e9 * seconds / static_cast<double>(state.iterations()) / static_cast<double>(steps);
}

/// Registers a solver under "problem/solver" with the repetitions a median needs.
template <class Function>
void compare(const char* name, Function function) {
  benchmark::RegisterBenchmark(name, function)
      ->UseManualTime()
      ->Repetitions(9)
      ->MinTime(0.05)
      ->ReportAggregatesOnly(true);
}

// Our own solvers on the paper's case, so that every program measures them in the same run as its peer.

/// Ten seconds in steps of 1 ms; the error that each of the fixed-step methods stays below.
inline constexpr long kSteps = 10'000;
inline constexpr double kStep = 1e-3;           // [s]
inline constexpr double kRk4Error = 5e-8;       // of peak, at 1 ms
inline constexpr double kAdaptiveError = 1e-8;  // of peak

[[nodiscard]] State solveRk4(const PaperCase& problem);          // by type, input in blocks
[[nodiscard]] State solveRk4Virtual(const PaperCase& problem);   // any System
[[nodiscard]] State solveRk4OneSincos(const PaperCase& problem); // by type, fed by OneSincosRail
[[nodiscard]] State solveExact(const PaperCase& problem);        // a propagation every 1 ms
[[nodiscard]] State solveDopri5(const PaperCase& problem);       // at the tolerance that gives kAdaptiveError

}  // namespace vehicle::bench
