// main() of every benchmark program: Google Benchmark's table, then one line per problem and peer, and the same as
// CSV where --results=FOLDER names a place for it.
//
// Names are "problem/solver"; solvers that begin with "ours" are compared with every peer of the problem.

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

namespace {

struct Measurement {
  std::string problem;
  std::string solver;
  double median = 0.0;      // [ns] a step, or a whole run where the problem says so
  double deviation = 0.0;   // [ns] standard deviation over the repetitions
  double error = 0.0;       // of the end state, of peak
};

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
        if (const auto error = run.counters.find("error"); error != run.counters.end()) entry.error = error->second.value;
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
                   ours.solver, ours.median, ours.error, ours.median / peer.median, peer.solver, peer.median, peer.error);
      }
    }
  }

  void write(const std::string& folder, const std::string& program) const {
    std::ofstream file(folder + "/" + program + ".csv");
    file << "problem,solver,median_ns,stddev_ns,error,compiler,flags,commit,threads\n";
    for (const auto& [name, m] : measurements_) {
      file << fmt::format("{},{},{:.5g},{:.2g},{:.3e},g++ {},{},{},1\n", m.problem, m.solver, m.median, m.deviation,
                          m.error, __VERSION__, VEHICLE_FLAGS, VEHICLE_COMMIT);
    }
  }

 private:
  std::map<std::string, Measurement> measurements_;
};

}  // namespace

int main(int argc, char** argv) {
  std::string results;
  std::vector<char*> arguments;
  for (int i = 0; i < argc; ++i) {
    constexpr const char* kResults = "--results=";
    if (std::strncmp(argv[i], kResults, std::strlen(kResults)) == 0) results = argv[i] + std::strlen(kResults);
    else arguments.push_back(argv[i]);
  }
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
