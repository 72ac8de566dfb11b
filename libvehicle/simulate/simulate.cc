#include "libvehicle/simulate/simulate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "libvehicle/excitation/excitation.h"
#include "libvehicle/simulate/initial_state.h"
#include "libvehicle/simulate/shared_run.h"
#include "libvehicle/simulate/thread_choice.h"

namespace vehicle {

namespace {

void requirePositive(const char* name, double value, const char* unit) {
  if (!(std::isfinite(value) && value > 0.0)) {
    throw std::invalid_argument(fmt::format("{} = {} {}, must be finite and > 0", name, value, unit));
  }
}

void checkChoice(const RunChoice& choice) {
  if (choice.speed) requirePositive("speed", *choice.speed, "m/s");
  requirePositive("step", choice.step, "s");
  requirePositive("relative tolerance", choice.relative, "");
  requirePositive("absolute tolerance", choice.absolute, "");
  requirePositive("accuracy", choice.accuracy, "");
  const std::vector<std::string>& maps = equationMapNames();
  if (std::find(maps.begin(), maps.end(), choice.map) == maps.end()) {
    throw std::invalid_argument(unknownName("map", choice.map, maps));
  }
  if (choice.refine < 1) throw std::invalid_argument(fmt::format("refine = {}, must be >= 1", choice.refine));
}

// Fills the history sample by sample and watches over it.
class Recorder {
 public:
  Recorder(const System& system, const Input& input, const Schedule& schedule, const Progress& progress)
      : system_(system), input_(input), schedule_(schedule), progress_(progress), history_(system.outputs()),
        u_(3 * static_cast<std::size_t>(system.channels())) {
    history_.reserve(static_cast<std::size_t>(schedule.samples()));
  }

  bool operator()(int sample, int segment, double t, std::span<const double> x) {
    input_.evaluate(segment, t, u_);
    const std::span<double> row = history_.append(t);
    system_.output(x, u_, row.subspan(1));
    for (std::size_t column = 1; column < row.size(); ++column) {
      if (!std::isfinite(row[column])) {
        throw RunFailed(fmt::format("{} is not finite at t = {:.6g} s", history_.columns()[column].name, t));
      }
    }
    // Asking after every sample would cost more than a step of the exact method.
    constexpr int kSamplesBetweenReports = 16;
    if (!progress_ || sample % kSamplesBetweenReports != 0) return true;
    return progress_(static_cast<double>(sample + 1) / schedule_.samples());
  }

  TimeHistory take() { return std::move(history_); }

 private:
  const System& system_;
  const Input& input_;
  const Schedule& schedule_;
  const Progress& progress_;
  TimeHistory history_;
  std::vector<double> u_;  // (3 w) heights, rates, accelerations
};

}  // namespace

RunResult simulate(const Vehicle& vehicle, const Scenario& scenario, const RunChoice& choice,
                   const Progress& progress) {
  checkChoice(choice);
  requireRight(vehicle, scenario);

  RunResult result;
  result.form = choice.form.empty() ? defaultForm(vehicle) : choice.form;
  const Topology topology = topologyOf(vehicle);
  result.method = choice.method.empty() ? defaultMethod(result.form, 2 * topology.coordinates) : choice.method;
  result.speed = choice.speed.value_or(scenario.run.speed);
  if (const std::string misfit = methodMisfit(result.method, result.form); !misfit.empty()) {
    throw std::invalid_argument(misfit);
  }
  if (const std::string misfit = threadsMisfit(result.form, result.method, choice.threads, choice.scheme);
      !misfit.empty()) {
    throw std::invalid_argument(misfit);
  }
  if (const std::string misfit = mapMisfit(result.form, result.method, choice.threads, choice.scheme, choice.map);
      !misfit.empty()) {
    throw std::invalid_argument(misfit);
  }

  const std::unique_ptr<System> system = buildForm(result.form, vehicle, scenario.gravity);
  const Input input = inputOf(scenario, topology, result.speed);
  const Schedule schedule(input, scenario.run.output_step);
  const std::vector<double> x0 = initialState(*system, vehicle, scenario, input);
  const MethodSettings settings{{choice.step, choice.refine}, {choice.relative, choice.absolute}, choice.accuracy};

  Recorder recorder(*system, input, schedule, progress);
  const auto begin = std::chrono::steady_clock::now();
  try {
    const bool only_serial = choice.threads == 0 && !canBeShared(result.form, result.method);
    SharedRun run = runShared(result.method, *system, input, schedule, settings, x0, std::ref(recorder),
                              {choice.threads, only_serial ? nameOf(Scheme::kSerial) : choice.scheme,
                               equationMapOf(choice.map), choice.team});
    result.statistics = run.statistics;
    result.scheme = nameOf(run.scheme);
    result.threads = run.threads;
    result.team = std::move(run.team);
    result.work = std::move(run.work);
    result.decision = std::move(run.decision);
  } catch (const std::runtime_error& failure) {
    throw RunFailed(fmt::format("{} with {}: {}", result.form, result.method, failure.what()));
  }
  result.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result.history = recorder.take();
  return result;
}

}  // namespace vehicle
