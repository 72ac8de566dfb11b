// What a long run of one vehicle costs beyond its steps: measured, and written while it goes; and what a rail of samples
// costs beside a harmonic one.
//
// usage: bench_long_run [SAMPLES]      output samples of the long run, 5 ms apart (default 4000000)
// Prints CSV: what ran, processor seconds, nanoseconds an output sample, their ratio to the steps alone (or to the harmonic rail),
// megabytes of memory at most, what it was built by. Every row is a process of its own: its memory is that of this row,
// and processor time does not count what a neighbour on the machine takes away.

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/built_by.h"
#include "libvehicle/excitation/excitation.h"
#include "libvehicle/project/run_files.h"
#include "libvehicle/simulate/methods.h"
#include "libvehicle/track/rail_piece.h"
#include "libvehicle/xml/reader.h"
#include "tests/support/own_process.h"

namespace vehicle {
namespace {

struct Cost {
  double seconds = 0.0;
  double megabytes = 0.0;
};

Cost costOf(const std::function<void()>& work) {
  const std::optional<rusage> usage = test::usageOf(work);
  if (!usage) std::exit(1);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return {seconds(usage->ru_utime) + seconds(usage->ru_stime), static_cast<double>(usage->ru_maxrss) / 1024.0};
}

void print(const std::string& what, const Cost& cost, double samples, double base) {
  fmt::print("{},{:.2f},{:.0f},{:.2f},{:.0f},{}\n", what, cost.seconds, 1e9 * cost.seconds / samples,
             cost.seconds / base, cost.megabytes, bench::builtBy());
}

/// The paper's vehicle on its rail, 5 ms between samples.
Model modelOf(double duration) {
  Scenario scenario = readScenario(VEHICLE_SOURCE_DIR "/models/scenarios/paper-20mps.xml").orThrow();
  scenario.run.duration = duration;
  Vehicle vehicle = readVehicle(VEHICLE_SOURCE_DIR "/models/vehicles/al-oraiqat-2017.xml").orThrow();
  CompiledModel model = compileChecked(std::move(vehicle), scenario.gravity);
  return {std::move(model), std::move(scenario), {}, {}};
}

constexpr double kOutputStep = 5e-3;  // [s]

/// A run whose samples are looked at and nothing is done with them.
void blindRun(const std::string& method, const RunProblem& problem) {
  const MethodSettings settings{{1e-3}, {}, 1e-10};
  (void)methodNamed(method).make(problem, settings)->run(problem.schedule, problem.x0, [](auto&&...) { return true; });
}

void longRun(long samples) {
  const Model model = modelOf(static_cast<double>(samples) * kOutputStep);
  const std::string folder = std::filesystem::temp_directory_path() / "bench_long_run";
  for (const std::string method : {"exact", "rk4", "dopri5"}) {
    const auto count = static_cast<double>(samples);
    RunChoice choice;
    choice.method = method;
    const Cost alone = costOf([&] {
      const std::unique_ptr<System> system = buildForm("flat", model.vehicle);
      const Input input = inputOf(model.scenario, model.vehicle.topology, 20.0);
      const Schedule schedule(input, kOutputStep);
      const std::vector<double> x0(static_cast<std::size_t>(system->size()), 0.0);
      blindRun(method, {*system, input, schedule, x0});
    });
    print(method + ": steps alone", alone, count, alone.seconds);
    for (const std::string ending : {"", ".csv", ".h5"}) {
      std::vector<std::string> files;
      if (!ending.empty()) files.push_back(folder + ending);
      const Cost whole = costOf([&] { (void)simulateAndStore(model, choice, {files, "bench"}); });
      print(fmt::format("{}: measured, {}", method, ending.empty() ? "no file" : "written to " + ending), whole, count,
            alone.seconds);
      for (const std::string& file : files) std::filesystem::remove(file);
    }
  }
}

/// 499 s at 20 m/s by rk4 in steps of 1 ms, on a wave of 10 m: as a harmonic, or as a million samples 1 cm apart.
void sampledRail() {
  const Model model = modelOf(499.0);
  constexpr double kWave = 2.0 * std::numbers::pi / 10.0, kSpacing = 0.01;
  const auto run = [&](const std::vector<RailPiece>& rail, double end) {
    const std::unique_ptr<System> system = buildForm("flat", model.vehicle);
    const Input input = inputOf(rail, model.vehicle.topology, Travel(20.0), {end, kOutputStep});
    const Schedule schedule(input, kOutputStep);
    const std::vector<double> x0(static_cast<std::size_t>(system->size()), 0.0);
    blindRun("rk4", {*system, input, schedule, x0});
  };
  const auto sampled = [&](double end) {
    std::vector<double> heights(1'000'000);
    for (std::size_t i = 0; i < heights.size(); ++i) {
      heights[i] = 1e-3 * std::sin(kWave * kSpacing * static_cast<double>(i));
    }
    run(piecesOf(std::make_shared<SampledRail>(std::make_shared<StoredSamples>(std::move(heights)),
                                               SampleGridOverDistance{0.0, kSpacing})),
        end);
  };
  RailPiece wave;
  wave.to = INFINITY;
  wave.waves = {{kWave, 0.0, 1e-3}};
  const Cost harmonic = costOf([&] { run({wave}, 499.0); });
  print("rk4: rail of one harmonic", harmonic, 499.0 / kOutputStep, harmonic.seconds);
  print("rk4: rail of 1e6 samples; the first second", costOf([&] { sampled(1.0); }), 1.0 / kOutputStep,
        harmonic.seconds);
  print("rk4: rail of 1e6 samples; all of it", costOf([&] { sampled(499.0); }), 499.0 / kOutputStep, harmonic.seconds);
}

}  // namespace
}  // namespace vehicle

int main(int count, char** words) {
  const long samples = count > 1 ? std::atol(words[1]) : 4'000'000;
  if (count > 2 || samples < 1) {
    fmt::print(stderr, "usage: bench_long_run [SAMPLES]\n");
    return 2;
  }
  fmt::print("what,cpu_seconds,ns_per_sample,ratio,memory_mb,{}\n", vehicle::bench::kBuiltByColumns);
  vehicle::longRun(samples);
  vehicle::sampledRail();
  return 0;
}
