#include "libvehicle/validation/plan.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "libvehicle/linear/motion_rates.h"
#include "libvehicle/simulate/forms.h"
#include "libvehicle/simulate/run_plan.h"

namespace vehicle {

namespace {

// Largest memory that the histories of one case may take together.
constexpr double kMostBytes = 2.0 * 1024.0 * 1024.0 * 1024.0;

class Planner {
 public:
  Planner(const CompiledModel& model, const ValidationChoice& choice) : model_(model), choice_(choice) {}

  ValidationPlan plan() {
    add(keyOf("matrix", "exact"));
    for (const std::string& form : forms()) planForm(form);
    return std::move(plan_);
  }

 private:
  [[nodiscard]] std::vector<std::string> forms() const {
    if (!choice_.forms.empty()) return choice_.forms;
    std::vector<std::string> all;
    std::copy_if(formNames().begin(), formNames().end(), std::back_inserter(all),
                 [](const std::string& form) { return !isPrintedVariant(form); });
    return all;
  }

  void planForm(const std::string& form) {
    if (const ProblemList unsupported = formUnsupported(form, model_.topology); !unsupported.empty()) {
      plan_.unsupported.push_back({form, "", unsupported[0].message});
      return;
    }
    // A method that asks for a symmetric vehicle is run on the form where it can be, and else only said not to fit if
    // somebody named it.
    const bool all = choice_.methods.empty();
    bool runs = false;
    for (const std::string& method : all ? methodNames() : choice_.methods) {
      const std::string unsupported = methodUnsupported(method, form, model_);
      if (unsupported.empty()) {
        planMethod(form, method);
        runs = true;
      } else if (!all || methodNamed(method).unsupportedVehicle == nullptr) {
        plan_.unsupported.push_back({form, method, unsupported});
      }
    }
    if (runs) return;
    const std::string method = defaultMethod(form, model_.topology);
    plan_.notes.push_back(fmt::format("{}: none of the methods asked for can run it; it runs by {}", form, method));
    planMethod(form, method);
  }

  void planMethod(const std::string& form, const std::string& method) {
    RunKey key = keyOf(form, method);
    add(key);
    if (hasFixedSteps(key)) {
      key.refine = 2;
      add(key);
    }
    if (form != "flat") return;
    for (const SharedColumn& column : choice_.shared) {
      if (column.method == method) add(sharedKey(column));
    }
  }

  [[nodiscard]] RunKey keyOf(const std::string& form, const std::string& method) const {
    return {.form = form,
            .method = method,
            .step = choice_.run.step.value_or(kDefaultStep),
            .relative = choice_.run.relative,
            .absolute = choice_.run.absolute,
            .accuracy = choice_.run.accuracy};
  }

  [[nodiscard]] RunKey sharedKey(const SharedColumn& column) {
    RunKey key = keyOf("flat", column.method);
    key.scheme = column.scheme;
    key.threads =
        methodNamed(column.method).most_threads > 0 ? column.threads : std::min(column.threads, equationsOfFlat());
    key.map = column.map == "paper" && equationsOfFlat() != 4 ? "auto" : column.map;
    return key;
  }

  int equationsOfFlat() {
    if (!flat_equations_) {
      const std::unique_ptr<System> flat = buildForm("flat", model_);
      const EquationSet* cut = flat->equations();
      flat_equations_ = cut != nullptr ? static_cast<int>(cut->equations().size()) : 1;
    }
    return *flat_equations_;
  }

  /// A run that is planned already is not run again.
  void add(RunKey key) {
    if (std::find(plan_.runs.begin(), plan_.runs.end(), key) == plan_.runs.end()) plan_.runs.push_back(std::move(key));
  }

  const CompiledModel& model_;
  const ValidationChoice& choice_;
  ValidationPlan plan_;
  std::optional<int> flat_equations_;  // into which the flat form can be cut
};

}  // namespace

ValidationPlan validationPlanOf(const CompiledModel& model, const ValidationChoice& choice) {
  return Planner(model, choice).plan();
}

std::string equationsOf(const std::string& form) { return isPrintedVariant(form) ? form : "matrix"; }

bool areCompared(const std::vector<RunKey>& runs, std::size_t i, std::size_t j) {
  const RunKey& a = runs[i];
  const RunKey& b = runs[j];
  if (a.refine != 1) return false;
  if (b.refine == 1) return true;
  return a.method == "exact" && a.scheme.empty() && isLinearForm(b.form) &&
         equationsOf(a.form) == equationsOf(b.form) && (i == 0 || isPrintedVariant(a.form));
}

bool judgesAnything(const ValidationPlan& plan) {
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    for (std::size_t j = i + 1; j < plan.runs.size(); ++j) {
      if (areCompared(plan.runs, i, j) && equationsOf(plan.runs[i].form) == equationsOf(plan.runs[j].form)) return true;
    }
  }
  return false;
}

std::string caseRefusal(const ValidationPlan& plan, const CompiledModel& model, const Scenario& scenario,
                        double speed) {
  Scenario run = scenario;
  run.run.speed = speed;
  // Steps of fixed accuracy become shorter and shorter, and rounding is all that two runs could differ in.
  constexpr double kMostGrowth = 1e12;
  const double growth = MotionRates(*buildForm("matrix", model)).growth() * durationOf(run);
  if (growth > std::log(kMostGrowth)) {
    return fmt::format(
        "the vehicle cannot stand: its motion grows 1e{:.0f}-fold over {:.4g} s, beyond any comparison; take a shorter "
        "duration, or look at what `vehicle check` says of it",
        growth / std::numbers::ln10, durationOf(run));
  }
  const double samples = durationOf(run) / scenario.run.output_step + 1.0;
  const double columns = static_cast<double>(model.outputs.size() + 1);
  const double all = 8.0 * samples * columns * static_cast<double>(plan.runs.size());
  if (all <= kMostBytes) return {};
  return fmt::format(
      "{} runs of {:.0f} samples need {:.1f} GiB, allowed are {:.0f}; take a longer output_step, a shorter duration or "
      "fewer forms and methods",
      plan.runs.size(), samples, all / 1073741824.0, kMostBytes / 1073741824.0);
}

}  // namespace vehicle
