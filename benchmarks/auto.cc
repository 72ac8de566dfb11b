// What `--threads auto` takes against the best choice made by hand, and what sharing the rail is worth.
//
// usage: bench_auto [train N ...] [rail] [seconds S] [turns T] [--csv FILE]
//
// train N   every way to run a train of N of the paper's vehicles by rk4, and auto, alternately
// rail      one vehicle on 2, 16 and 64 harmonics, swept and with a sine and cosine at every half step: serial,
//           pipeline and split on 1, 2 and 4 threads
// seconds   how long the serial run should take (1); what auto spends on its calibration is part of its time
//
// Wall time of whole runs, threads started included. Ways more than twice as slow as the best in a run of a fiftieth of
// that length take no part. Medians of T turns (7); the state at the end is the same in every row of a problem (hash).

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "benchmarks/built_by.h"
#include "libvehicle/definition/train.h"
#include "libvehicle/excitation/excitation.h"
#include "libvehicle/flat/flat_form.h"
#include "libvehicle/flat/flat_train.h"
#include "libvehicle/integrate/rk4.h"
#include "libvehicle/model/topology.h"
#include "libvehicle/partition/schemes/pipeline.h"
#include "libvehicle/simulate/flat_split_run.h"
#include "libvehicle/simulate/shared_run.h"
#include "libvehicle/threads/placement.h"
#include "libvehicle/xml/reader.h"

namespace vehicle::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kStep = 1e-3;          // [s]
constexpr double kOutput = 64 * kStep;  // [s]
constexpr double kSpacing = 12.0;       // [m]

struct Row {
  std::string problem;
  std::string way;
  int threads;
  long steps;
  double ns;      // a step, median of the turns
  double least;
  double spread;  // of the turns, largest less smallest
  std::uint64_t hash;
  std::string chosen{};  // of auto: what it took in each turn
};

struct Settings {
  double seconds = 1.0;
  int turns = 7;
};

std::uint64_t hashOf(std::span<const double> x) {
  std::uint64_t hash = 1469598103934665603u;  // FNV-1a
  for (const double value : x) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    for (int byte = 0; byte < 8; ++byte) hash = (hash ^ (bits >> (8 * byte) & 255)) * 1099511628211u;
  }
  return hash;
}

Scenario scenarioOf(double duration, int harmonics) {
  Scenario scenario =
      readScenario(VEHICLE_SOURCE_DIR "/models/scenarios/paper-20mps-extended.xml").orThrow();
  scenario.run.duration = duration;
  scenario.run.output_step = kOutput;
  if (harmonics == 0) return scenario;
  const Harmonic first = scenario.track->harmonics.front();
  scenario.track->harmonics.clear();
  for (int order = 1; order <= harmonics; ++order) {
    Harmonic each = first;
    each.name.clear();
    each.order = order;
    each.amplitude = first.amplitude / order;
    scenario.track->harmonics.push_back(each);
  }
  return scenario;
}

Vehicle trainOf(int count) {
  Vehicle vehicle = readVehicle(VEHICLE_SOURCE_DIR "/models/vehicles/al-oraiqat-2017.xml").orThrow();
  if (count == 1) return vehicle;
  Train train;
  train.name = "equal";
  TrainVehicle units;
  units.name = "unit";
  units.count = count;
  units.spacing = kSpacing;
  units.vehicle = std::move(vehicle);
  train.vehicles = {std::move(units)};
  Coupling coupling;
  coupling.stiffness_z = 50e3;
  coupling.damping_z = 20e3;
  coupling.end_x = 0.5 * kSpacing;
  train.couplings = {coupling};
  return assembled(train);
}

/// A system on a rail that lasts so many steps.
struct Problem {
  Vehicle vehicle;
  std::unique_ptr<System> system;
  Input input;
  Schedule schedule;
  std::vector<double> start;
  long steps;

  Problem(int count, long wanted, int harmonics = 0)
      : vehicle(trainOf(count)),
        system(buildFlatSystem(compile(vehicle, 9.81))),
        input(inputOf(scenarioOf(static_cast<double>(std::max(8l, wanted / 64)) * kOutput, harmonics),
                      topologyOf(vehicle), 20.0)),
        schedule(input, kOutput),
        start(static_cast<std::size_t>(system->size()), 1e-4),
        steps(stepsOfRun(schedule, {kStep})) {}

  [[nodiscard]] RunProblem run() const { return {*system, input, schedule, start}; }
};

/// Runs a problem and tells what it took, where there was something to choose.
struct Solver {
  std::string way;
  int threads;  // 0: auto
  std::function<std::string(const Problem&, const Observer&)> run;
};

Solver byName(const std::string& method, const std::string& scheme, int threads) {
  const std::string way = threads == 0 ? "auto" : method == "rk4_split" ? "split" : scheme;
  return {way, threads, [=](const Problem& problem, const Observer& observe) {
            MethodSettings settings;
            settings.step.step = kStep;
            const Sharing sharing{threads, scheme.empty() ? std::nullopt : std::optional(schemeOf(scheme))};
            const SharedRun run = runShared(method, problem.run(), settings, observe, {sharing, {}});
            return threads == 0 ? fmt::format("{} {} in {:.1f} ms", nameOf(run.scheme), run.threads,
                                                  1e3 * run.decision.calibration)
                                    : std::string{};
          }};
}

double timeOf(const Solver& solver, const Problem& problem, Row& row) {
  const auto begin = Clock::now();
  const std::string chosen = solver.run(problem, [&](int sample, int, double, std::span<const double> x) {
    if (sample == problem.schedule.samples() - 1) row.hash = hashOf(x);
    return true;
  });
  if (!chosen.empty()) row.chosen += (row.chosen.empty() ? "" : "; ") + chosen;
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// All solvers alternately.
std::vector<Row> race(const std::string& name, const Problem& problem, const std::vector<Solver>& solvers, int turns) {
  std::vector<Row> rows;
  for (const Solver& solver : solvers) rows.push_back({name, solver.way, solver.threads, problem.steps, 0, 0, 0, 0});
  std::vector<std::vector<double>> times(solvers.size());
  for (int turn = 0; turn < turns; ++turn) {
    for (std::size_t i = 0; i < solvers.size(); ++i) {
      times[i].push_back(1e9 * timeOf(solvers[i], problem, rows[i]) / static_cast<double>(problem.steps));
    }
  }
  for (std::size_t i = 0; i < solvers.size(); ++i) {
    std::sort(times[i].begin(), times[i].end());
    rows[i].ns = times[i][times[i].size() / 2];
    rows[i].least = times[i].front();
    rows[i].spread = times[i].back() - times[i].front();
  }
  return rows;
}

/// Without those that are more than twice as slow as the best; auto stays.
std::vector<Solver> worthTheirTurns(const Problem& probe, const std::vector<Solver>& all) {
  const std::vector<Row> rows = race("", probe, all, 3);
  double best = 1e300;
  for (const Row& row : rows) best = std::min(best, row.least);
  std::vector<Solver> kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].threads == 0 || rows[i].least < 2.0 * best) kept.push_back(all[i]);
  }
  return kept;
}

std::vector<Row> train(int count, const Settings& settings) {
  const double guess = 58e-9 * count;  // [s] a step
  const Problem probe(count, std::lround(0.02 * settings.seconds / guess));
  const Problem problem(count, std::lround(settings.seconds / guess));
  std::vector<Solver> all = {byName("rk4", "serial", 1)};
  for (const int threads : {2, 4}) {
    for (const char* scheme : {"stages", "halo", "pipeline"}) all.push_back(byName("rk4", scheme, threads));
  }
  all.push_back(byName("rk4", "", 0));
  std::vector<Row> rows = race(fmt::format("train_{}", count), problem, worthTheirTurns(probe, all), settings.turns);
  const Row& chosen = rows.back();
  const auto best =
      std::min_element(rows.begin(), rows.end() - 1, [](const Row& a, const Row& b) { return a.ns < b.ns; });
  fmt::print("\ntrain of {}, {} steps\n", count, problem.steps);
  for (const Row& row : rows) {
    fmt::print("  {:<10}{:>3}{:>14.1f} ns a step  least {:<12.1f} {}\n", row.way, row.threads, row.ns, row.least,
               row.chosen);
  }
  fmt::print("  auto is {:.3f} of the best ({} {}), {:.3f} of the serial code\n", chosen.ns / best->ns, best->way,
             best->threads, chosen.ns / rows.front().ns);
  std::fflush(stdout);
  return rows;
}

/// Rows by the formula at every half step, one sine and cosine per frequency each: what the rail costs where nobody has
/// thought about it. Differs from sweepRows() by Input::sweepError().
BlockRows evaluatedRows(const Input& input) {
  return [&input](const StepBlock& block, int rows, double* u) {
    const std::size_t width = 2 * static_cast<std::size_t>(input.channels());
    for (int i = 0; i < rows; ++i, u += width) {
      input.evaluate(block.segment, block.begin + 0.5 * block.h * (2 * block.first + i), {u, width});
    }
  };
}

/// The rail by the formula at every half step.
Solver literally(int threads) {
  return {"pipeline_literal", threads, [=](const Problem& problem, const Observer& observe) {
            const auto& form = dynamic_cast<const FlatForm&>(*problem.system);
            const Rk4<FlatRhs, FlatRhs::kStates> stepper(*form.rhs());
            runPipelined(stepper, problem.run(), {{kStep}, evaluatedRows(problem.input), threads}, observe, {});
            return std::string{};
          }};
}

std::vector<Row> rail(const Settings& settings) {
  std::vector<Row> all;
  for (const int harmonics : {2, 16, 64}) {
    const double guess = 40e-9 + 10e-9 * harmonics;  // [s] a step
    const Problem problem(1, std::lround(0.2 * settings.seconds / guess), harmonics);
    std::vector<Solver> solvers = {byName("rk4", "serial", 1), byName("rk4", "pipeline", 2),
                                   byName("rk4", "pipeline", 4), byName("rk4_split", "serial", 1),
                                   byName("rk4_split", "split", 2)};
    for (const int threads : {1, 2, 4}) solvers.push_back(literally(threads));
    const std::vector<Row> rows = race(fmt::format("rail_{}", harmonics), problem, solvers, settings.turns);
    fmt::print("\none vehicle on {} harmonics\n", harmonics);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::size_t alone = i < 3 ? 0 : i < 5 ? 3 : 5;
      fmt::print("  {:<18}{:>3}{:>12.1f} ns a step{:>8.2f} x its serial form{:>8.2f} x rk4\n",
                 rows[i].way, rows[i].threads, rows[i].ns, rows[alone].ns / rows[i].ns,
                 rows[0].ns / rows[i].ns);
    }
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

}  // namespace
}  // namespace vehicle::bench

int main(int argc, char** argv) {
  using namespace vehicle::bench;
  Settings settings;
  std::vector<int> counts;
  bool asks_rail = false;
  std::string csv;
  std::string word;
  for (int i = 1; i < argc; ++i) {
    const std::string each = argv[i];
    const bool number = !each.empty() && each.find_first_not_of("0123456789.") == std::string::npos;
    if (!number) word = each;
    if (word == "rail") asks_rail = true;
    if (word == "--csv" && i + 1 < argc) csv = argv[++i];
    if (!number) continue;
    if (word == "train") counts.push_back(std::clamp(std::atoi(each.c_str()), 1, 4096));
    if (word == "seconds") settings.seconds = std::clamp(std::atof(each.c_str()), 0.01, 60.0);
    if (word == "turns") settings.turns = std::clamp(std::atoi(each.c_str()), 1, 101);
  }
  requireKnownCommit(csv);
  fmt::print("{} cores\n", vehicle::allowedCores().size());
  std::vector<Row> rows;
  const auto add = [&](std::vector<Row> more) { rows.insert(rows.end(), more.begin(), more.end()); };
  for (const int count : counts) add(train(count, settings));
  if (asks_rail) add(rail(settings));
  if (csv.empty()) return 0;
  const bool begun = std::ifstream(csv).good();
  std::ofstream out(csv, std::ios::app);  // a row a way, of as many calls as it takes
  if (!begun) {
    out << "problem,way,threads,steps,ns_per_step,least_ns,spread_ns,state_hash,chosen," << kBuiltByColumns << '\n';
  }
  for (const Row& r : rows) {
    out << fmt::format("{},{},{},{},{:.2f},{:.2f},{:.2f},{:016x},{},{}\n", r.problem, r.way, r.threads, r.steps, r.ns,
                       r.least, r.spread, r.hash, r.chosen, builtBy());
  }
  return out ? 0 : 3;
}
