// One vehicle and trains of N = 1 .. 4096 vehicles, shared among threads: every design and thread count against the
// best serial code, its step as a multiple of its floor, and the map speed-up(N, threads) with the crossover.
//
// usage: bench_partition [vehicle] [oversubscribed] [trains] [blocks] [--largest N] [--most-threads N]
//                        [--csv FILE]
//
// Wall time from the first output sample to the last, so that starting threads does not count; designs take turns, the
// median of all turns is shown. All runs give the same bits (tests/partition/solvers_test.cc); a hash of the final
// state stands in the CSV.

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "benchmarks/built_by.h"
#include "benchmarks/train_case.h"
#include "libvehicle/flat/flat_model.h"
#include "libvehicle/integrate/fixed_steps.h"
#include "libvehicle/integrate/rk4.h"
#include "libvehicle/integrate/run.h"
#include "libvehicle/partition/map/cut_order.h"
#include "libvehicle/partition/run.h"
#include "libvehicle/partition/schemes/blocked_rk4.h"
#include "libvehicle/threads/placement.h"

namespace vehicle::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kStep = 1e-3;  // [s]
constexpr const char* kOneWay = "line one way";

double seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

std::uint64_t hashOf(std::span<const double> x) {
  std::uint64_t hash = 1469598103934665603u;  // FNV-1a
  for (const double value : x) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    for (int byte = 0; byte < 8; ++byte) hash = (hash ^ (bits >> (8 * byte) & 255)) * 1099511628211u;
  }
  return hash;
}

/// Times the part of a run between its first and last sample.
struct Stopwatch {
  Clock::time_point first{};
  Clock::time_point last{};
  int samples = 0;
  std::uint64_t hash = 0;
  int final_sample = 0;

  Observer observer() {
    return [this](int sample, int, double, std::span<const double> x) {
      if (sample == 1) first = Clock::now();
      if (sample == final_sample) {
        last = Clock::now();
        hash = hashOf(x);
      }
      samples = sample;
      return true;
    };
  }
};

struct Problem {
  int vehicles;
  TrainSystem system;
  Input input;
  Schedule schedule;
  std::vector<double> start;
  int steps_of_sample;

  [[nodiscard]] RunProblem run() const { return {system, input, schedule, start}; }
  Problem(int count, int samples, int steps)
      : vehicles(count),
        system(count),
        input(trainInput(count, (samples + 0.5) * steps * kStep)),
        schedule(input, steps * kStep),
        start(static_cast<std::size_t>(8 * count), 0.0),
        steps_of_sample(steps) {
    for (std::size_t i = 0; i < start.size(); ++i) start[i] = 1e-3 / static_cast<double>(1 + i % 7);
  }
};

using Solve = std::function<void(const Problem&, const Observer&)>;

struct Design {
  std::string name;
  int threads;
  Solve solve;
};

struct Figure {
  std::string problem;
  std::string design;
  int threads;
  double ns;      // of a step
  double least;   // of the turns
  double spread;  // of the turns, largest less smallest
  std::uint64_t hash;
};

Design shared(const std::string& name, Scheme scheme, EquationMap map, int threads) {
  return {name, threads, [=](const Problem& problem, const Observer& observe) {
            runPartitioned(problem.run(), {.step = kStep}, observe, {threads, scheme, map});
          }};
}

/// The flat form's own stepper, equations and step seen as one by the compiler: one vehicle.
Design byType() {
  return {"serial by type", 1, [](const Problem& problem, const Observer& observe) {
            constexpr std::array<std::size_t, 8> kInner = {0, 2, 4, 6, 1, 3, 5, 7};
            std::array<double, 8> start{}, shown{};
            for (std::size_t i = 0; i < 8; ++i) start[i] = problem.start[kInner[i]];
            Rk4<FlatRhs, 8> stepper{FlatRhs(paperParameters())};
            FixedSteps(stepper, problem.input, {.step = kStep})
                .run(problem.schedule, start, [&](int sample, int segment, double t, std::span<const double> x) {
                  for (std::size_t i = 0; i < 8; ++i) shown[kInner[i]] = x[i];
                  return observe(sample, segment, t, shown);
                });
          }};
}

Design blocked() {
  return {"serial blocked", 1, [](const Problem& problem, const Observer& observe) {
            makeBlockedRk4(problem.run(), {.step = kStep})->run(problem.schedule, problem.start, observe);
          }};
}

Design exact() {
  return {"exact serial", 1, [](const Problem& problem, const Observer& observe) {
            runExact({problem.system, problem.input, problem.schedule, problem.start}, observe);
          }};
}

/// One way of a cache line [ns]: two threads answer each other, half a round trip.
double oneWay() {
  struct alignas(128) Line {
    std::atomic<long> epoch{0};
  };
  constexpr long kTrips = 10000;
  Line lines[2];
  double took = 0.0;
  runTeam(2, {}, [&](Member& me) {
    const auto await = [&](int whom, long epoch) {
      me.wait([&] { return lines[whom].epoch.load(std::memory_order_acquire) >= epoch; }, whom);
    };
    const Clock::time_point begin = Clock::now();
    for (long epoch = 1; epoch <= kTrips; ++epoch) {
      if (me.number() == 1) await(0, epoch);
      lines[me.number()].epoch.store(epoch, std::memory_order_release);
      if (me.number() == 0) await(1, epoch);
    }
    if (me.number() == 0) took = seconds(Clock::now() - begin);
  });
  return 1e9 * took / (2.0 * kTrips);
}

/// All designs on one problem, alternately; the way of a cache line takes its turns with them, because a virtual machine
/// changes its cores' distance from one second to the next. It is the last figure.
std::vector<Figure> race(const std::string& name, const Problem& problem, const std::vector<Design>& designs,
                         int turns) {
  std::vector<std::vector<double>> times(designs.size());
  std::vector<std::uint64_t> hashes(designs.size());
  std::vector<double> ways;
  for (int turn = 0; turn <= turns; ++turn) {
    ways.push_back(oneWay());
    for (std::size_t d = 0; d < designs.size(); ++d) {
      Stopwatch watch;
      watch.final_sample = problem.schedule.samples() - 1;
      designs[d].solve(problem, watch.observer());
      const double steps = static_cast<double>(problem.steps_of_sample) * (watch.final_sample - 1);
      hashes[d] = watch.hash;
      if (turn > 0) times[d].push_back(1e9 * seconds(watch.last - watch.first) / steps);  // turn 0 warms up
    }
  }
  std::vector<Figure> figures;
  for (std::size_t d = 0; d < designs.size(); ++d) {
    const auto [low, high] = std::minmax_element(times[d].begin(), times[d].end());
    figures.push_back({name, designs[d].name, designs[d].threads, median(times[d]), *low, *high - *low, hashes[d]});
  }
  const auto [low, high] = std::minmax_element(ways.begin(), ways.end());
  figures.push_back({name, kOneWay, 2, median(ways), *low, *high - *low, 0});
  return figures;
}

double best(const std::vector<Figure>& figures) {
  double least = figures.front().ns;
  for (const Figure& figure : figures) {
    if (figure.threads == 1 && figure.design.rfind("serial", 0) == 0) least = std::min(least, figure.ns);
  }
  return least;
}

void print(const std::vector<Figure>& figures, double serial) {
  const double one_way = figures.back().ns;
  fmt::print("{:<34}{:>9}{:>14}{:>10}{:>12}{:>12}\n", "design", "threads", "ns/step", "least", "speed-up",
             "x floor");
  for (const Figure& figure : figures) {
    const bool stages = figure.design.rfind("stages", 0) == 0;
    const bool one_exchange = figure.design.rfind("halo", 0) == 0;
    const double floor = figure.threads == 1 ? 0.0 : stages ? 4.0 * one_way : one_exchange ? one_way : 0.0;
    fmt::print("{:<34}{:>9}{:>14.1f}{:>10.1f}{:>12.2f}{:>12}\n", figure.design, figure.threads, figure.ns,
               figure.least, serial / figure.ns, floor > 0.0 ? fmt::format("{:.2f}", figure.ns / floor) : "");
  }
}

std::vector<Figure> oneVehicle(int most_threads) {
  const Problem problem(1, 300, 64);
  std::vector<Design> designs = {byType(), blocked(),
                                 shared("stages auto", Scheme::kStages, EquationMap::kAuto, 1),
                                 shared("halo auto", Scheme::kHalo, EquationMap::kAuto, 1)};
  for (int threads = 2; threads <= most_threads; ++threads) {
    designs.push_back(shared("stages auto", Scheme::kStages, EquationMap::kAuto, threads));
    if (threads < 4) designs.push_back(shared("stages body", Scheme::kStages, EquationMap::kBody, threads));
    if (threads == 4) designs.push_back(shared("stages paper", Scheme::kStages, EquationMap::kPaper, threads));
    designs.push_back(shared("halo auto", Scheme::kHalo, EquationMap::kAuto, threads));
  }
  std::vector<Figure> figures = race("vehicle", problem, designs, 7);
  fmt::print("\none vehicle, four equations, rk4\n");
  print(figures, best(figures));

  // The exact method steps from sample to sample.
  const Problem samples(1, 12000, 1);
  const std::vector<Design> exact_designs = {exact()};
  const std::vector<Figure> more = race("vehicle", samples, exact_designs, 7);
  fmt::print("\none vehicle, exact propagator, a sample every step\n");
  print(more, more.front().ns);
  figures.insert(figures.end(), more.begin(), more.end());
  return figures;
}

std::vector<Figure> oversubscribed() {
  std::vector<Figure> figures;
  for (const int vehicles : {1, 16}) {
    const Problem problem(vehicles, 100, 32);
    std::vector<Design> designs = {blocked()};
    for (const int threads : {2, 4, 8}) {
      if (threads > 4 * vehicles) continue;
      designs.push_back(shared("stages auto", Scheme::kStages, EquationMap::kAuto, threads));
      designs.push_back(shared("halo auto", Scheme::kHalo, EquationMap::kAuto, threads));
    }
    const std::vector<Figure> more = race(fmt::format("oversubscribed_{}", vehicles), problem, designs, 5);
    fmt::print("\n{} vehicle(s) on {} cores, more threads than cores\n", vehicles, allowedCores().size());
    print(more, best(more));
    figures.insert(figures.end(), more.begin(), more.end());
  }
  return figures;
}

std::vector<Figure> trains(int largest) {
  std::vector<Figure> figures;
  const std::vector<int> thread_counts = {2, 4};
  fmt::print("\ntrains: speed-up over the best serial code\n{:>6}{:>16}", "N", "serial ns/step");
  for (const char* name : {"stages 2", "halo 2", "halo 4"}) fmt::print("{:>12}", name);
  fmt::print("{:>20}\n", "serial ns/veh/step");
  int crossover = 0;
  std::set<int> sizes = {3, 6, 12, 24, 48};
  for (int n = 1; n <= 4096; n *= 2) sizes.insert(n);
  for (const int n : sizes) {
    if (n > largest) continue;
    const int steps = n <= 64 ? 64 : 32;
    const Problem problem(n, std::clamp(40000 / n / steps * 10, 6, 400), steps);
    std::vector<Design> designs = {blocked()};
    if (n == 1) designs.push_back(byType());
    designs.push_back(shared("stages auto", Scheme::kStages, EquationMap::kAuto, 2));
    designs.push_back(shared("halo auto", Scheme::kHalo, EquationMap::kAuto, 2));
    designs.push_back(shared("halo auto", Scheme::kHalo, EquationMap::kAuto, 4));
    const std::vector<Figure> more = race(fmt::format("train_{}", n), problem, designs, 7);
    const double serial = best(more);
    const std::size_t first = n == 1 ? 2 : 1;
    fmt::print("{:>6}{:>16.0f}", n, serial);
    const std::size_t last = more.size() - 1;
    for (std::size_t d = first; d < last; ++d) fmt::print("{:>12.2f}", serial / more[d].ns);
    fmt::print("   least:");
    for (std::size_t d = first; d < last; ++d) fmt::print("{:>6.2f}", more[0].least / more[d].least);
    fmt::print("{:>20.1f}{:>8.0f}\n", serial / n, more[last].ns);
    const bool wins = std::any_of(more.begin() + static_cast<std::ptrdiff_t>(first), more.end() - 1,
                                  [&](const Figure& figure) { return figure.ns < serial; });
    if (!wins) crossover = 0;
    if (wins && crossover == 0) crossover = n;
    figures.insert(figures.end(), more.begin(), more.end());
  }
  if (crossover > 0) {
    fmt::print("crossover: from N = {} on, threads win\n", crossover);
  } else {
    fmt::print("no crossover up to N = {}\n", largest);
  }
  return figures;
}

/// How long a cache block of the serial code should be.
std::vector<Figure> blocks() {
  std::vector<Figure> figures;
  for (const int n : {64, 1024, 4096}) {
    const Problem problem(n, std::max(6, 8192 / n), 32);
    const CutRun cut(problem.run());
    const EquationGraph graph(cut.set());
    std::vector<Design> designs;
    for (const int block : {8, 16, 32, 64, 128, 256, 4 * n}) {
      designs.push_back({fmt::format("block of {}", block), 1, [&, block](const Problem&, const Observer& observe) {
                           BlockedRk4 rk4(cut.set(), graph, cut.input(), {0, graph.size()}, block);
                           std::copy(cut.x0().begin(), cut.x0().end(), rk4.x());
                           walkSteps(
                               {problem.schedule, {.step = kStep}, rk4.stepsOfBlock()},
                               [&](const StepBlock& steps) { rk4.enter(steps); },
                               [&](double h, int k) {
                                 rk4.prepare(k);
                                 rk4.step(h, k, [](int) {});
                               },
                               [&](const StepPause& here) {
                                 return here.sample < 0 || observe(here.sample, 0, here.end,
                                                                   {rk4.x(), static_cast<std::size_t>(8 * n)});
                               });
                         }});
    }
    const std::vector<Figure> more = race(fmt::format("blocks_{}", n), problem, designs, 7);
    fmt::print("\ntrain of {}: equations in a cache block\n", n);
    for (const Figure& figure : more) fmt::print("{:<20}{:>12.1f} ns a vehicle\n", figure.design, figure.ns / n);
    figures.insert(figures.end(), more.begin(), more.end());
  }
  return figures;
}

}  // namespace
}  // namespace vehicle::bench

int main(int argc, char** argv) {
  using namespace vehicle::bench;
  std::set<std::string> wanted;
  std::string csv;
  int largest = 4096;
  int most_threads = 4;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--csv" && i + 1 < argc) {
      csv = argv[++i];
    } else if (word == "--most-threads" && i + 1 < argc) {
      most_threads = std::clamp(std::atoi(argv[++i]), 1, 4);  // equations
    } else if (word == "--largest" && i + 1 < argc) {
      largest = std::atoi(argv[++i]);
    } else {
      wanted.insert(word);
    }
  }
  requireKnownCommit(csv);
  const auto asked = [&](const char* what) { return wanted.empty() || wanted.count(what) > 0; };
  fmt::print("{} cores\n", vehicle::allowedCores().size());
  std::vector<Figure> figures;
  const auto add = [&](std::vector<Figure> more) { figures.insert(figures.end(), more.begin(), more.end()); };
  if (asked("vehicle")) add(oneVehicle(most_threads));
  if (asked("oversubscribed")) add(oversubscribed());
  if (asked("trains")) add(trains(largest));
  if (wanted.count("blocks") > 0) add(blocks());
  if (csv.empty()) return 0;
  std::ofstream out(csv);
  out << "problem,design,threads,ns_per_step,spread_ns,state_hash," << kBuiltByColumns << '\n';
  for (const Figure& f : figures) {
    out << fmt::format("{},{},{},{:.1f},{:.1f},{:016x},{}\n", f.problem, f.design, f.threads, f.ns, f.spread, f.hash,
                       builtBy());
  }
  return out ? 0 : 3;
}
