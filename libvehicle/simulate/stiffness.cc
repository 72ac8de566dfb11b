#include "libvehicle/simulate/stiffness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/excitation/excitation.h"
#include "libvehicle/integrate/stability.h"
#include "libvehicle/integrate/tableau.h"
#include "libvehicle/system/dense_solvers.h"

namespace vehicle {

namespace {

using Complex = std::complex<double>;

constexpr int kMostStates = 400;         // half a second for their eigenvalues
constexpr long kFewSteps = 1000;         // done at once, stiff or not
constexpr double kDiedAway = 10.0;    // tolerances
constexpr double kWorthASentence = 4.0;  // times the step

/// The step [s] that errs by the tolerance in a motion exp(lambda t): the error grows with its sixth power.
double stepThatFollows(Complex lambda, double tolerance) {
  const double size = std::abs(lambda);
  if (size == 0.0) return std::numeric_limits<double>::infinity();
  constexpr double kSmall = 0.1;  // |h lambda| where the first term is all of the error
  const double error = modeError(kDopri5, kSmall * lambda / size);
  return kSmall / size * std::pow(tolerance / error, 1.0 / 6.0);
}

double fastestOf(const Input& input) {
  double fastest = 0.0;
  for (int s = 0; s < input.segments(); ++s) {
    for (const double omega : input.segment(s).angular_frequency) fastest = std::max(fastest, omega);
  }
  return fastest;
}

/// The tolerance of a step relative to the motion: the absolute one counts against the largest displacement of a body.
double toleranceOf(const RunChoice& choice, const System& form, const RunResult& result) {
  const std::vector<Channel>& states = form.states();
  double largest = 0.0;
  for (std::size_t i = 0; i < result.summaries.size(); ++i) {
    const Channel& column = result.history.columns()[i + 1];  // time is the first
    if (column.unit != "m" || std::find(states.begin(), states.end(), column) == states.end()) continue;
    largest = std::max(largest, result.summaries[i].peak());
  }
  return choice.relative + (largest > 0.0 ? choice.absolute / largest : 0.0);
}

}  // namespace

std::optional<StiffRun> stiffRun(const Statistics& statistics, const FollowedMotion& motion,
                                 std::span<const Complex> eigenvalues) {
  if (statistics.steps < kFewSteps) return std::nullopt;
  StiffRun run;
  run.step = motion.duration / static_cast<double>(statistics.steps);
  run.needed = stepThatFollows({0.0, motion.fastest_input}, motion.tolerance);
  for (const Complex& each : eigenvalues) {
    const bool is_followed = modeError(kDopri5, run.step * each) <= kDiedAway * motion.tolerance;
    if (is_followed) run.needed = std::min(run.needed, stepThatFollows(each, motion.tolerance));
    if (!is_followed && std::abs(each) > std::abs(run.eigenvalue)) run.eigenvalue = each;
  }
  if (run.eigenvalue == 0.0 || run.needed < kWorthASentence * run.step) return std::nullopt;
  return run;
}

std::string stiffnessNote(const CompiledModel& model, const Scenario& scenario, const RunChoice& choice,
                          const RunResult& result) {
  if (result.method != "dopri5") return {};
  if (model.states.size() > kMostStates) return {};
  const bool linear = isLinearForm(result.form);
  const std::unique_ptr<System> form = buildForm(linear ? result.form : "matrix", model);
  const Eigen::VectorXcd eigenvalues = form->linear()->A.eigenvalues();
  const FollowedMotion motion{result.reached, toleranceOf(choice, *form, result),
                              fastestOf(inputOf(scenario, model.topology, result.speed))};
  const std::optional<StiffRun> stiff =
      stiffRun(result.statistics, motion, {eigenvalues.data(), static_cast<std::size_t>(eigenvalues.size())});
  if (!stiff) return {};
  return fmt::format(
      "dopri5 took {} steps of {:.2g} s, where the motion asks for {:.2g} s: a mode of {:.3g} 1/s that has died away "
      "keeps "
      "them short; {}",
      result.statistics.steps, stiff->step, stiff->needed, std::abs(stiff->eigenvalue),
      linear ? "take --method exact, which needs no steps"
             : "an implicit method would take long ones, this program has none; --form matrix --method exact gives the "
               "linear answer");
}

}  // namespace vehicle
