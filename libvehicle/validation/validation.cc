#include "libvehicle/validation/validation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/excitation/excitation.h"
#include "libvehicle/linear/motion_rates.h"
#include "libvehicle/simulate/run_plan.h"
#include "libvehicle/system/dense_solvers.h"

namespace vehicle {
namespace {

// With fewer samples than this, a column's error may happen to pass through zero at all of them.
constexpr std::size_t kFewSamples = 50;

/// The differences of few samples, none smaller against its column's peak than the largest of all columns that are
/// more than rounding.
Eigen::VectorXd liftedFromZeros(const Eigen::VectorXd& difference, const CaseSize& size,
                                const Eigen::VectorXd& rounding) {
  const Eigen::VectorXd& peak = size.motion.output;
  double largest = 0.0;
  for (Eigen::Index i = 0; i < peak.size(); ++i) {
    if (peak(i) > rounding(i)) largest = std::max(largest, difference(i) / peak(i));
  }
  return difference.cwiseMax(largest * peak);
}

class Case {
 public:
  Case(const CompiledModel& model, const Scenario& scenario, const ValidationChoice& choice,
       const ValidationProgress& progress)
      : model_(model), scenario_(scenario), choice_(choice), progress_(progress) {
    report_.vehicle = model.vehicle.name;
    report_.scenario = scenario.name;
    report_.speed = choice.run.speed.value_or(scenario.run.speed);
  }

  ValidationReport validate() {
    plan();
    for (std::size_t i = 0; i < report_.runs.size() && !report_.stopped; ++i) run(i);
    if (!report_.stopped) judge();
    if (!report_.stopped) warn();
    return std::move(report_);
  }

 private:
  struct Equations {
    std::string name;
    std::unique_ptr<System> system;
    std::optional<CaseSize> size;
    std::optional<double> rk4_step;  // [s]
  };

  /// What simulate() would refuse, reported before anything is built of it.
  void requireCase() const {
    requireRunnable(model_, scenario_);
    const double step = choice_.run.step.value_or(kDefaultStep);
    if (!(std::isfinite(step) && step > 0.0))
      throw std::invalid_argument(fmt::format("step = {} s, must be finite and > 0", step));
  }

  void plan() {
    requireCase();
    ValidationPlan plan = validationPlanOf(model_, choice_);
    if (const std::string refusal = caseRefusal(plan, model_, scenario_, report_.speed); !refusal.empty()) {
      throw std::invalid_argument(refusal);
    }
    report_.unsupported = std::move(plan.unsupported);
    report_.notes = std::move(plan.notes);
    for (RunKey& key : plan.runs) {
      if (hasFixedSteps(key)) key.step = stepOf(key.form);
      report_.runs.emplace_back().key = std::move(key);
    }
    histories_.resize(report_.runs.size());
  }

  [[nodiscard]] double largestStep() const { return choice_.run.step.value_or(kDefaultStep); }

  /// The step asked for, or the one that resolves the fastest mode if that is smaller.
  double stepOf(const std::string& form) {
    Equations& own = equations(form);
    if (!own.rk4_step) {
      const double resolving = MotionRates(*own.system).resolvingRk4Step(duration());
      own.rk4_step = std::min(largestStep(), resolving);
      if (resolving < largestStep()) {
        report_.notes.push_back(
            fmt::format("rk4 takes steps of {:.3g} ms instead of {:.4g} ms: the fastest mode of {} asks for it",
                        1e3 * resolving, 1e3 * largestStep(), report_.vehicle));
      }
    }
    return *own.rk4_step;
  }

  /// Of the run [s]; a rig has no speed and gives its duration. Only asked where the scenario is right.
  [[nodiscard]] double duration() const {
    return scenario_.run.distance ? *scenario_.run.distance / report_.speed : *scenario_.run.duration;
  }

  Equations& equations(const std::string& form) {
    const std::string name = equationsOf(form);
    for (Equations& known : equations_) {
      if (known.name == name) return known;
    }
    equations_.push_back({name, buildForm(name, model_), std::nullopt, std::nullopt});
    return equations_.back();
  }

  void run(std::size_t index) {
    ValidationRun& run = report_.runs[index];
    RunChoice choice = choice_.run;
    choice.measures = false;
    choice.form = run.key.form;
    choice.method = run.key.method;
    choice.refine = run.key.refine;
    choice.step = run.key.step;
    choice.sharing = {run.key.threads, run.key.scheme.empty() ? Scheme::kSerial : schemeOf(run.key.scheme),
                      equationMapOf(run.key.map)};
    const double runs = static_cast<double>(report_.runs.size());
    const auto report_progress = [&](double share) {
      return !progress_ || progress_((static_cast<double>(index) + share) / runs, run.key.text());
    };
    if (!report_progress(0.0)) {
      report_.stopped = true;
      return;
    }
    const double most = run.key.scheme.empty() ? HUGE_VAL : timeLimitOf(run.key);
    const auto begin = std::chrono::steady_clock::now();
    bool too_long = false;
    try {
      RunResult result = simulate(model_, scenario_, choice, [&](double share) {
        too_long = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() > most;
        return !too_long && report_progress(share);
      });
      run.statistics = result.statistics;
      run.wall_seconds = result.wall_seconds;
      if (too_long) {
        run.ending = RunEnding::kOutOfTime;
        run.reason = fmt::format("not done after {:.3g} s, its time limit", most);
        return;
      }
      // Reported is what ran, whatever was asked for.
      run.key.scheme = result.scheme == nameOf(Scheme::kSerial) ? "" : result.scheme;
      run.key.threads = result.threads;
      report_.stopped = result.statistics.stopped;
      if (report_.stopped) return;
      run.ending = RunEnding::kFinished;
      histories_[index] = std::move(result.history);
    } catch (const RunFailed& failure) {
      run.ending = RunEnding::kFailed;
      run.reason = failure.what();
    }
  }

  /// The reference once more, measured between its samples: a wheel may lift between two of them.
  void warn() {
    if (!finished(0)) return;
    RunChoice choice;
    choice.speed = choice_.run.speed;
    choice.form = report_.runs[0].key.form;
    choice.method = report_.runs[0].key.method;
    choice.keep = Keep::kNothing;
    report_.warnings = simulate(model_, scenario_, choice).warnings;
  }

  [[nodiscard]] double timeLimitOf(const RunKey& shared) const {
    if (!choice_.shared_time_limit) return HUGE_VAL;
    const auto serial = find(shared.form, shared.method, shared.refine);
    const double steps = serial ? static_cast<double>(report_.runs[*serial].statistics.steps) : 0.0;
    return *choice_.shared_time_limit * (1.0 + steps / 10'000.0);
  }

  [[nodiscard]] bool finished(std::size_t i) const { return report_.runs[i].ending == RunEnding::kFinished; }

  [[nodiscard]] std::optional<std::size_t> find(const std::string& form, const std::string& method, int refine) const {
    for (std::size_t i = 0; i < report_.runs.size(); ++i) {
      const RunKey& key = report_.runs[i].key;
      if (key.form == form && key.method == method && key.refine == refine && key.scheme.empty() && finished(i)) {
        return i;
      }
    }
    return std::nullopt;
  }

  /// The sizes of a run's equations, read from the exact solution where there is one.
  const CaseSize& sizeFor(std::size_t run) {
    const std::string& form = report_.runs[run].key.form;
    Equations& own = equations(form);
    if (!own.size) {
      const Input input = inputOf(scenario_, model_.topology, report_.speed);
      const std::optional<std::size_t> exact = find(own.name, "exact", 1);
      const double finer = finerStep(*own.system, input);
      own.size =
          finer < scenario_.run.output_step && isLinearForm(own.name)
              ? sizeOfCase(*own.system, model_, input, finerHistory(own.name, finer), scenario_.run.output_step)
              : sizeOfCase(*own.system, model_, input, histories_[exact.value_or(run)], scenario_.run.output_step);
    }
    return *own.size;
  }

  /// Output step [s] at which the peaks of the motion show: the scenario's own may fall between them. Not finer
  /// than kMostSamples allow.
  [[nodiscard]] double finerStep(const System& system, const Input& input) const {
    constexpr double kRadians = 0.25;
    constexpr double kMostSamples = 50'000.0;
    double fastest = system.linear()->A.eigenvalues().cwiseAbs().maxCoeff();
    for (int s = 0; s < input.segments(); ++s) {
      for (const double omega : input.segment(s).angular_frequency) fastest = std::max(fastest, omega);
    }
    const double finest = (input.end() - input.begin()) / kMostSamples;
    const double cuts = std::ceil(scenario_.run.output_step / std::max(kRadians / fastest, finest));
    return scenario_.run.output_step / std::max(1.0, cuts);
  }

  [[nodiscard]] TimeHistory finerHistory(const std::string& form, double step) const {
    Scenario finer = scenario_;
    finer.run.output_step = step;
    RunChoice choice = choice_.run;
    choice.measures = false;
    choice.form = form;
    choice.method = "exact";
    return simulate(model_, finer, choice).history;
  }

  void judge() {
    std::vector<RunSize> sizes(report_.runs.size());
    for (std::size_t i = 0; i < report_.runs.size(); ++i) {
      if (!finished(i)) continue;
      const RunKey& key = report_.runs[i].key;
      Eigen::VectorXd step_difference;
      if (hasFixedSteps(key)) {
        const auto other = find(key.form, key.method, 3 - key.refine);
        step_difference = largestDifference(histories_[i], histories_[other.value_or(i)]);
      }
      const long steps = report_.runs[i].statistics.steps;
      sizes[i] = sizeOfRun(sizeFor(i), key, steps, step_difference);
      if (hasFixedSteps(key) && histories_[i].samples() < kFewSamples) {
        sizes[i] = sizeOfRun(sizeFor(i), key, steps, liftedFromZeros(step_difference, sizeFor(i), sizes[i].rounding));
      }
    }
    std::vector<RunKey> keys;
    for (const ValidationRun& each : report_.runs) keys.push_back(each.key);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      for (std::size_t j = i + 1; j < keys.size(); ++j) {
        if (!areCompared(keys, i, j)) continue;
        if (finished(i) && finished(j)) {
          compare(i, j, sizes);
        } else {
          leaveUnjudged(i, j);
        }
      }
    }
  }

  void leaveUnjudged(std::size_t i, std::size_t j) {
    const ValidationRun& missing = report_.runs[finished(i) ? j : i];
    PairAgreement& pair = report_.pairs.emplace_back();
    pair.first = i;
    pair.second = j;
    pair.verdict = Verdict::kNotJudged;
    pair.why = fmt::format("{}: {}", missing.key.text(), missing.reason);
  }

  void compare(std::size_t i, std::size_t j, const std::vector<RunSize>& sizes) {
    const RunKey& a = report_.runs[i].key;
    const RunKey& b = report_.runs[j].key;
    std::optional<Expectation> expectation;
    if (equationsOf(a.form) == equationsOf(b.form)) expectation = expectationOf(sizeFor(i), a, sizes[i], b, sizes[j]);
    PairAgreement pair = compareHistories(histories_[i], histories_[j], expectation);
    pair.first = i;
    pair.second = j;
    if (b.refine == 2) report_.runs[j].order = orderOf(i, j, expectation->rounding);
    report_.pairs.push_back(std::move(pair));
  }

  /// log2(err(h) / err(h/2)) with the error over all state columns relative to their peaks; nothing where
  /// rounding hides it.
  [[nodiscard]] std::optional<double> orderOf(std::size_t exact, std::size_t half, const Eigen::VectorXd& rounding) {
    const RunKey& key = report_.runs[half].key;
    const auto full = find(key.form, key.method, 1);
    if (!full) return std::nullopt;
    const CaseSize& size = sizeFor(exact);
    const Eigen::VectorXd coarse = largestDifference(histories_[exact], histories_[*full]);
    const Eigen::VectorXd fine = largestDifference(histories_[exact], histories_[half]);
    double coarse_error = 0.0, fine_error = 0.0, noise = 0.0;
    for (const OutputKey& state : model_.state_keys) {
      const int i = model_.outputs.column(state);
      if (size.motion.output(i) <= rounding(i)) continue;
      coarse_error = std::max(coarse_error, coarse(i) / size.motion.output(i));
      fine_error = std::max(fine_error, fine(i) / size.motion.output(i));
      noise = std::max(noise, rounding(i) / size.motion.output(i));
    }
    if (!(fine_error > 3.0 * noise)) return std::nullopt;
    return std::log2(coarse_error / fine_error);
  }

  const CompiledModel& model_;
  const Scenario& scenario_;
  const ValidationChoice& choice_;
  const ValidationProgress& progress_;
  ValidationReport report_;
  std::vector<TimeHistory> histories_;  // shape (runs)
  std::vector<Equations> equations_;
};

}  // namespace

ValidationReport validate(const CompiledModel& model, const Scenario& scenario, const ValidationChoice& choice,
                          const ValidationProgress& progress) {
  return Case(model, scenario, choice, progress).validate();
}

ValidationReport validate(const Vehicle& vehicle, const Scenario& scenario, const ValidationChoice& choice,
                          const ValidationProgress& progress) {
  requireRight(vehicle, scenario);
  return validate(compileChecked(vehicle, scenario.gravity), scenario, choice, progress);
}

}  // namespace vehicle
