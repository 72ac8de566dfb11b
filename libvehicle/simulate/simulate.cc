#include "libvehicle/simulate/simulate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

#include "libvehicle/excitation/excitation.h"
#include "libvehicle/matrix/matrix_form.h"
#include "libvehicle/simulate/initial_state.h"
#include "libvehicle/simulate/run_plan.h"
#include "libvehicle/simulate/run_warnings.h"
#include "libvehicle/simulate/shared_run.h"
#include "libvehicle/simulate/thread_choice.h"
#include "libvehicle/simulate/vehicle_warnings.h"

namespace vehicle {

namespace {

void requirePositive(const char* name, double value, const char* unit) {
  if (!(std::isfinite(value) && value > 0.0)) {
    throw std::invalid_argument(fmt::format("{} = {} {}, must be finite and > 0", name, value, unit));
  }
}

void checkChoice(const RunChoice& choice) {
  if (choice.speed) requirePositive("speed", *choice.speed, "m/s");
  if (choice.step) requirePositive("step", *choice.step, "s");
  requirePositive("relative tolerance", choice.relative, "");
  requirePositive("absolute tolerance", choice.absolute, "");
  requirePositive("accuracy", choice.accuracy, "");
  if (choice.refine < 1) throw std::invalid_argument(fmt::format("refine = {}, must be >= 1", choice.refine));
}

/// What a history may take, as validate() has it.
constexpr double kMostHistoryBytes = 2.0 * 1024.0 * 1024.0 * 1024.0;

void requireMemory(const Schedule& schedule, const System& system, Keep keep) {
  if (keep == Keep::kNothing) return;
  const double samples = keep == Keep::kOutputs ? schedule.outputs() : schedule.outputs() * schedule.cut();
  const double columns = static_cast<double>(system.outputs().size() + 1);
  const double bytes = 8.0 * samples * columns;
  if (bytes <= kMostHistoryBytes) return;
  throw std::invalid_argument(
      fmt::format("a history of {:.0f} samples and {:.0f} columns needs {:.1f} GiB, allowed are {:.0f}; take a longer "
                  "output_step or a shorter run, or keep no history",
                  samples, columns, bytes / 1073741824.0, kMostHistoryBytes / 1073741824.0));
}

void append(Warnings more, Warnings& warnings) { std::move(more.begin(), more.end(), std::back_inserter(warnings)); }

Warning coarseSamples(const Schedule& schedule) {
  Warning warning;
  warning.code = WarningCode::kCoarseSamples;
  warning.value = schedule.outputStep() / schedule.cut();
  warning.unit = std::string("s");
  warning.message = fmt::format(
      "peaks, means and r.m.s. are of samples {:.3g} ms apart, too few for the fastest motion of so "
      "long a run",
      1e3 * *warning.value);
  warning.remedy = "run shorter";
  return warning;
}

/// Why a run may have grown beyond all numbers, as the end of the line that says it did; "" if nothing is known.
std::string causeAmong(const Warnings& warnings) {
  for (const Warning& each : warnings) {
    const bool grows = each.code == WarningCode::kUnstableStep || each.code == WarningCode::kCannotStand ||
                       each.code == WarningCode::kUnstableMode;
    if (!grows) continue;
    return fmt::format("; {}{}{}; {} [{}]", each.subject, each.subject.empty() ? "" : ": ", each.message, each.remedy,
                       wordOf(each.code));
  }
  return "";
}

/// Whether samples lie close enough for the series of ExactIntegrals.
bool isFollowed(const Schedule& schedule, double fastest) {
  return schedule.isResolved() && schedule.outputStep() / schedule.cut() * fastest <= ExactIntegrals::kMostTurn;
}

/// The run itself; model, scenario and choice are in order.
RunResult runRight(const CompiledModel& model, const Scenario& scenario, const RunChoice& choice,
                   const Progress& progress, HistorySink* sink = nullptr) {
  RunResult result;
  result.form = choice.form.empty() ? defaultForm(model.topology) : choice.form;
  result.method = choice.method.empty() ? defaultMethod(result.form, model.states.size()) : choice.method;
  result.speed = choice.speed.value_or(scenario.run.speed);
  if (const std::string unsupported = methodUnsupported(result.method, result.form); !unsupported.empty()) {
    throw std::invalid_argument(unsupported);
  }
  if (const std::string why = threadsUnsupported(result.form, result.method, choice.sharing); !why.empty()) {
    throw std::invalid_argument(why);
  }
  if (const std::string why = mapUnsupported(result.form, result.method, choice.sharing); !why.empty()) {
    throw std::invalid_argument(why);
  }

  const std::unique_ptr<System> system = buildForm(result.form, model);
  const Input input = inputOf(scenario, model.topology, result.speed);
  const Method& method = methodNamed(result.method);
  const bool is_fixed_step = method.reads.step;
  RunPlan plan;
  double fastest = 0.0;  // [rad/s]
  if (choice.measures) {
    const MotionRates rates = motionRatesOf(result.form, *system, model);
    fastest = rates.fastest();
    plan = planOf({.fixed_step = is_fixed_step,
                   .step = choice.step,
                   .refine = choice.refine,
                   .output_step = scenario.run.output_step,
                   .duration = input.end() - input.begin(),
                   .settle = choice.settle},
                  rates);
    result.warnings = restWarnings(model);
    const bool stands = std::none_of(result.warnings.begin(), result.warnings.end(),
                                     [](const Warning& each) { return each.code == WarningCode::kCannotStand; });
    append(motionWarnings(rates, stands), result.warnings);
    append(std::move(plan.warnings), result.warnings);
    result.notes = std::move(plan.notes);
  } else {
    plan.step = {choice.step.value_or(kDefaultStep), choice.refine};
  }
  const Schedule schedule =
      choice.measures ? Schedule(input, plan.sampling) : Schedule(input, scenario.run.output_step);
  requireMemory(schedule, *system, choice.keep);
  const std::vector<double> x0 = initialState(*system, model, scenario, input);
  const MethodSettings settings{plan.step, {choice.relative, choice.absolute}, choice.accuracy};
  result.step = is_fixed_step ? plan.step.step : 0.0;

  const RunProblem problem{*system, input, schedule, x0};
  StoredHistory stored;
  Watch watch{.keepers = {}, .counted = choice.keep, .measures = choice.measures, .progress = progress};
  if (choice.keep != Keep::kNothing) watch.keepers.push_back({&stored, choice.keep});
  if (sink != nullptr) watch.keepers.push_back({sink, Keep::kOutputs});
  Recorder recorder(problem, watch);
  if (choice.measures && method.error.law == ErrorLaw::kNone && isFollowed(schedule, fastest)) {
    recorder.integrateExactly();
  }
  const auto begin = std::chrono::steady_clock::now();
  try {
    ThreadRequest request{choice.sharing, choice.team};
    if (choice.sharing.threads == 0 && !canBeShared(result.form, result.method)) {
      request.sharing.scheme = Scheme::kSerial;
    }
    SharedRun run = runShared(method, problem, settings, std::ref(recorder), request);
    result.statistics = run.statistics;
    result.scheme = nameOf(run.scheme);
    result.threads = run.threads;
    result.team = std::move(run.team);
    result.work = std::move(run.work);
    result.decision = std::move(run.decision);
  } catch (const std::runtime_error& failure) {
    throw RunFailed(
        fmt::format("{} with {}: {}{}", result.form, result.method, failure.what(), causeAmong(result.warnings)));
  }
  recorder.requireKept();
  result.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result.history = choice.keep == Keep::kNothing ? TimeHistory(system->outputs()) : stored.take();
  result.summaries = recorder.summaries();
  result.reached = recorder.reached();
  result.outputs = recorder.outputs();
  append(rangeWarnings(model.outputs, result.summaries, model.gravity), result.warnings);
  if (!schedule.isResolved() && !choice.step) append({coarseSamples(schedule)}, result.warnings);
  return result;
}

}  // namespace

void requireRunnable(const CompiledModel& model, const Scenario& scenario) {
  ProblemList problems = check(scenario);
  if (problems.empty()) problems.append(check(scenario, model.vehicle));
  if (!problems.empty()) throw InvalidInput(std::move(problems));
  if (model.gravity == scenario.gravity) return;
  throw std::invalid_argument(
      fmt::format("the model was compiled under a gravity of {} m/s^2, the scenario has {}; "
                  "compile it under that",
                  model.gravity, scenario.gravity));
}

RunResult simulate(const Vehicle& vehicle, const Scenario& scenario, const RunChoice& choice,
                   const Progress& progress) {
  checkChoice(choice);
  requireRight(vehicle, scenario);
  return runRight(compileChecked(vehicle, scenario.gravity), scenario, choice, progress);
}

RunResult simulate(const CompiledModel& model, const Scenario& scenario, const RunChoice& choice,
                   const Progress& progress, HistorySink* sink) {
  checkChoice(choice);
  requireRunnable(model, scenario);
  return runRight(model, scenario, choice, progress, sink);
}

}  // namespace vehicle
