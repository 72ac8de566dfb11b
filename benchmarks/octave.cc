// Octave's ode45 on the paper's case through docs/matlab/paper_ode45.m; processor time measured inside Octave, start-up
// excluded.

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <unistd.h>

#include <fmt/format.h>

#include "benchmarks/measure.h"

namespace vehicle::bench {
namespace {

struct OctaveRun {
  State state{};
  double seconds = 0.0;
};

// The last line of the script's file: t,z1,dz1,z2,dz2,zk,dzk,phi,dphi.
State lastState(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line, last;
  while (std::getline(in, line)) last = line;
  std::array<double, 9> v{};
  std::stringstream cells(last);
  for (double& value : v) {
    std::getline(cells, line, ',');
    value = std::atof(line.c_str());
  }
  return {v[5], v[7], v[1], v[3], v[6], v[8], v[2], v[4]};
}

OctaveRun runOctave() {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / fmt::format("vehicle-ode45-{}.csv", getpid());
  const std::string command = fmt::format(
      "{} --no-gui --norc --quiet --eval \"addpath('{}/docs/matlab'); begun = cputime; "
      "paper_ode45('extended', 1e-9, 1e-12, '{}'); printf('%.9g', cputime - begun);\"",
      OCTAVE_PROGRAM, VEHICLE_SOURCE_DIR, file.string());
  OctaveRun run;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr || std::fscanf(pipe, "%lf", &run.seconds) != 1) run.seconds = NAN;
  if (pipe != nullptr) pclose(pipe);
  run.state = lastState(file);
  std::filesystem::remove(file);
  return run;
}

const bool kRegistered = [] {
  const auto add = [](const char* name, State (*solve)(const PaperCase&)) {
    compare(name, [=](benchmark::State& state) {
      measure(state, paperCase(), kAdaptiveError, 1, [&] { return solve(paperCase()); });
    });
  };
  add("run_10s_error_1e-8/ours_dopri5", solveDopri5);
  add("run_10s_error_1e-8/ours_exact", solveExact);
  benchmark::RegisterBenchmark("run_10s_error_1e-8/octave_ode45", [](benchmark::State& state) {
    for (auto _ : state) {
      const OctaveRun run = runOctave();
      const double error = paperCase().errorOf(run.state);
      if (isAnotherProblem(state, error, kAdaptiveError)) return;
      state.SetIterationTime(run.seconds);
      state.counters["error"] = error;
      state.counters["ns_per_step"] = 1e9 * run.seconds;
    }
  })->UseManualTime()->Iterations(1)->Repetitions(3)->ReportAggregatesOnly(true);
  return true;
}();

}  // namespace
}  // namespace vehicle::bench
