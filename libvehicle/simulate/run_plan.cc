#include "libvehicle/simulate/run_plan.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "libvehicle/integrate/step_walk.h"

namespace vehicle {

std::optional<Warning> stepWarning(double step, double duration, const MotionRates& rates, const std::string& option) {
  const double resolving = rates.resolvingRk4Step(duration);
  // A step that is a rounding longer than the one the program would take is as good.
  if (step <= resolving * (1.0 + 1e-9)) return std::nullopt;
  Warning warning;
  const bool grows = rates.rk4Grows(step);
  warning.code = grows ? WarningCode::kUnstableStep : WarningCode::kCoarseStep;
  warning.subject = option;
  warning.value = step;
  warning.unit = std::string("s");
  warning.message =
      fmt::format("a step of {:.4g} ms times the fastest motion of {:.4g} rad/s is {:.3g}; {}", 1e3 * step,
                  rates.fastest(), step * rates.fastest(),
                  grows ? "rk4 grows by itself beyond about 2.8"
                        : fmt::format("to follow it over this run takes {:.3g}", resolving * rates.fastest()));
  warning.remedy = fmt::format("take at most {:.3g} ms, or leave {} out", 1e3 * resolving, option);
  return warning;
}

RunPlan planOf(const PlanRequest& request, const MotionRates& rates) {
  RunPlan plan;
  plan.step = {request.step.value_or(kDefaultStep), request.refine};
  plan.sampling.output_step = request.output_step;
  plan.sampling.fastest = rates.fastestToShow();
  const SampleGrid grid(0.0, request.output_step);
  plan.sampling.count_from =
      grid.time(static_cast<std::int64_t>(std::ceil(request.settle / request.output_step - kSameInstant)));
  if (!request.fixed_step) return plan;
  if (request.step) {
    plan.sampling.steps = stepsOf(request.output_step, {*request.step, 1});
    if (auto warning = stepWarning(*request.step, request.duration, rates, "--step")) {
      plan.warnings.push_back(std::move(*warning));
    }
    return plan;
  }
  const double resolving = rates.resolvingRk4Step(request.duration);
  if (resolving >= kDefaultStep) return plan;
  plan.step.step = resolving;
  plan.notes.push_back(fmt::format(
      "rk4 takes steps of {:.3g} ms or less instead of {:g} ms: the fastest motion of the vehicle, {:.4g} rad/s, "
      "asks for it",
      1e3 * resolving, 1e3 * kDefaultStep, rates.fastest()));
  return plan;
}

}  // namespace vehicle
