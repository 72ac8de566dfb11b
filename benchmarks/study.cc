// What a study of a million designs costs: the paper's vehicle, steady state at 14 speeds, Sobol plan over eight
// parameters, evaluated and stored; and the same without the database, to see what storing costs.
//
// usage: bench_study DESIGNS THREADS FILE      FILE is written and removed; "none": nothing is stored
// Prints one CSV line: designs, threads, seconds, designs per second, ns per design and speed, megabytes of the file,
// megabytes of memory at most, what it was built by. One run a process: the memory is that of this run.

#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "benchmarks/built_by.h"
#include "libvehicle/study/runner.h"
#include "libvehicle/xml/reader.h"

namespace vehicle {
namespace {

constexpr const char* kStudy = R"(<?xml version="1.0" encoding="UTF-8"?>
<study name="million" format="1" evaluation="steady_state">
  <vehicle file="../vehicles/al-oraiqat-2017.xml"/>
  <scenario file="../scenarios/paper-20mps-extended.xml"/>
  <vary parameter="speed" from="20 km/h" to="150 km/h" count="14"/>
  <vary parameter="carbody.mass" from="45 t" to="65 t"/>
  <vary parameter="carbody.pitch_inertia" from="60 t*m^2" to="800 t*m^2"/>
  <vary parameter="front_bogie.mass, rear_bogie.mass" from="6 t" to="12 t"/>
  <vary parameter="primary.stiffness_z" from="2 MN/m" to="4 MN/m"/>
  <vary parameter="primary.damping_z" from="20 kN*s/m" to="60 kN*s/m"/>
  <vary parameter="secondary.stiffness_z" from="1 MN/m" to="4 MN/m"/>
  <vary parameter="secondary.damping_z" from="50 kN*s/m" to="200 kN*s/m"/>
  <plan kind="sobol" size="DESIGNS"/>
  <metric name="carbody.az.rms"/>
  <metric name="secondary_front.deflection.rms"/>
</study>
)";

int run(const std::string& designs, int threads, const std::string& file) {
  const std::string models = VEHICLE_SOURCE_DIR "/models/";
  std::string text = kStudy;
  text.replace(text.find("DESIGNS"), 7, designs);
  StudyInputs inputs;
  inputs.study = readStudyText(text, models + "studies/million.xml").orThrow();
  inputs.vehicle = readVehicle(models + "vehicles/al-oraiqat-2017.xml").orThrow();
  inputs.scenarios = {readScenario(models + "scenarios/paper-20mps-extended.xml").orThrow()};
  inputs.bound = bindStudy(inputs.study, inputs.vehicle, inputs.scenarios).orThrow();
  const DesignPlan plan = DesignPlan::of(inputs.study, inputs.bound).orThrow();

  ThreadExecutor executor(threads);
  double megabytes = 0.0;
  const auto begin = std::chrono::steady_clock::now();
  if (file == "none") {
    const StudyEvaluator evaluator(inputs, [&plan](std::int64_t design, std::span<double> values) {
      plan.valuesOf(static_cast<std::uint64_t>(design), values);
    });
    std::int64_t failed = 0;
    executor.run(evaluator, {{{0, static_cast<std::int64_t>(plan.size())}}, {}},
                 [&](Batch& batch) { failed += static_cast<std::int64_t>(batch.failures.size()); });
    if (failed > 0) return 1;
  } else {
    StudyTarget target;
    target.database = file;
    target.program = "bench_study";
    target.inputs = {{"million.xml", text}};
    const StudyOutcome outcome = runStudy(inputs, plan, target, executor);
    if (outcome.ending != Ending::kFinished || outcome.progress.failed > 0) return 1;
    megabytes = static_cast<double>(std::filesystem::file_size(file)) / 1e6;
    std::filesystem::remove(file);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto n = static_cast<double>(plan.size());
  fmt::print("designs,threads,stored,seconds,designs_per_second,ns_per_design_and_speed,file_mb,memory_mb,{}\n",
             bench::kBuiltByColumns);
  fmt::print("{},{},{},{:.3f},{:.0f},{:.1f},{:.1f},{:.1f},{}\n", plan.size(), threads, file != "none", seconds,
             n / seconds, 1e9 * seconds / n / 14.0, megabytes, static_cast<double>(usage.ru_maxrss) / 1024.0,
             bench::builtBy());
  return 0;
}

}  // namespace
}  // namespace vehicle

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: bench_study DESIGNS THREADS FILE|none\n");
    return 2;
  }
  try {
    return vehicle::run(argv[1], std::atoi(argv[2]), argv[3]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_study: {}\n", error.what());
    return 1;
  }
}
