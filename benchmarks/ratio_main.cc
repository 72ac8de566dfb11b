// main() of every benchmark program: Google Benchmark's table, then one line per problem and peer, and the same as
// CSV where --results=FOLDER names a place for it. --threads=2,4 is for the programs that measure threads.
//
// Names are "problem/solver"; solvers that begin with "ours" are compared with every peer of the problem.

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "benchmarks/built_by.h"
#include "benchmarks/measure.h"

namespace {

struct Measurement {
  std::string problem;
  std::string solver;
  double median = 0.0;      // [ns] a step, or a whole run where the problem says so
  double deviation = 0.0;   // [ns] standard deviation over the repetitions
  double error = 0.0;       // of the end state, of peak
  int threads = 1;
};

std::vector<vehicle::bench::ThreadedRegistration>& registrations() {
  static std::vector<vehicle::bench::ThreadedRegistration> all;
  return all;
}

// "2,4" -> {2, 4}; empty if it is not a list of numbers from 1.
std::vector<int> numbersIn(std::string_view list) {
  std::vector<int> numbers;
  while (!list.empty()) {
    int number = 0;
    const auto [end, problem] = std::from_chars(list.data(), list.data() + list.size(), number);
    if (problem != std::errc() || number < 1) return {};
    numbers.push_back(number);
    list.remove_prefix(static_cast<std::size_t>(end - list.data()));
    if (list.empty()) return numbers;
    if (list.front() != ',') return {};
    list.remove_prefix(1);
  }
  return {};
}

class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.error_occurred || run.run_type != Run::RT_Aggregate) continue;
      const std::string name = run.run_name.function_name;
      const auto slash = name.find('/');
      Measurement& entry = measurements_[name];
      entry.problem = name.substr(0, slash);
      entry.solver = name.substr(slash + 1);
      const auto cost = run.counters.find("ns_per_step");
      const double value = cost == run.counters.end() ? run.GetAdjustedRealTime() : cost->second.value;
      if (run.aggregate_name == "median") {
        entry.median = value;
        if (const auto error = run.counters.find("error"); error != run.counters.end())
          entry.error = error->second.value;
        if (const auto count = run.counters.find("threads"); count != run.counters.end()) {
          entry.threads = static_cast<int>(count->second.value);
        }
      }
      if (run.aggregate_name == "stddev") entry.deviation = value;
    }
  }

  void printRatios() const {
    fmt::print("\n{:<24} {:<26} {:>12} {:>9}   ratio to\n", "problem", "ours", "ns", "error");
    for (const auto& [name, ours] : measurements_) {
      if (!ours.solver.starts_with("ours")) continue;
      for (const auto& [peerName, peer] : measurements_) {
        if (peer.problem != ours.problem || peer.solver.starts_with("ours")) continue;
        fmt::print("{:<24} {:<26} {:>12.4g} {:>9.1e}   {:.3g} x {} ({:.4g} ns, error {:.1e})\n", ours.problem,
                   ours.solver, ours.median, ours.error, ours.median / peer.median, peer.solver, peer.median,
                   peer.error);
      }
    }
  }

  void write(const std::string& folder, const std::string& program) const {
    std::ofstream file(folder + "/" + program + ".csv");
    file << "problem,solver,median_ns,stddev_ns,error," << vehicle::bench::kBuiltByColumns << ",threads\n";
    for (const auto& [name, m] : measurements_) {
      file << fmt::format("{},{},{:.5g},{:.2g},{:.3e},{},{}\n", m.problem, m.solver, m.median, m.deviation, m.error,
                          vehicle::bench::builtBy(), m.threads);
    }
  }

 private:
  std::map<std::string, Measurement> measurements_;
};

}  // namespace

namespace vehicle::bench {

bool registerForThreads(ThreadedRegistration registration) {
  registrations().push_back(std::move(registration));
  return true;
}

}  // namespace vehicle::bench

int main(int argc, char** argv) {
  constexpr std::string_view kResults = "--results=";
  constexpr std::string_view kThreads = "--threads=";
  std::string results;
  std::vector<int> thread_counts = {2, 4};
  std::vector<char*> arguments;
  for (int i = 0; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument.starts_with(kResults)) {
      results = argument.substr(kResults.size());
    } else if (argument.starts_with(kThreads)) {
      thread_counts = numbersIn(argument.substr(kThreads.size()));
      if (thread_counts.empty()) {
        fmt::print(stderr, "{}: must be numbers of threads >= 1, e.g. --threads=2,4\n", argument);
        return 2;
      }
    } else {
      arguments.push_back(argv[i]);
    }
  }
  vehicle::bench::requireKnownCommit(results);
  for (const auto& registration : registrations()) registration(thread_counts);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.printRatios();
  const std::string program = argv[0];
  if (!results.empty()) reporter.write(results, program.substr(program.find_last_of('/') + 1));
  return 0;
}
