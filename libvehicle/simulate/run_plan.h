#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/diagnostics/warning.h"
#include "libvehicle/integrate/step_walk.h"
#include "libvehicle/linear/motion_rates.h"
#include "libvehicle/system/schedule.h"

namespace vehicle {

/// The longest fixed step that is taken where none is given [s].
inline constexpr double kDefaultStep = 1e-3;

/// How a run steps and where it is looked at.
struct RunPlan {
  FixedStep step;
  Sampling sampling;
  std::vector<std::string> notes;  // what was chosen for the user
  Warnings warnings;               // UNSTABLE_STEP, COARSE_STEP
};

/// What a run is asked for, as far as its plan goes.
struct PlanRequest {
  bool fixed_step = false;     // the method makes equal steps (rk4, rk4_split)
  std::optional<double> step;  // [s] given; empty: chosen
  int refine = 1;
  double output_step = 5e-3;  // [s]
  double duration = 0.0;      // [s]
  double settle = 0.0;        // [s] left out of the measurement, up to the next output sample
};

/// Without a step given, the one that resolves the fastest motion of the vehicle, at most kDefaultStep; where the rail is
/// faster, samples and with them steps follow the rail (Sampling). A step that was given is kept and judged.
[[nodiscard]] RunPlan planOf(const PlanRequest& request, const MotionRates& rates);

/// UNSTABLE_STEP or COARSE_STEP of an rk4 step that was given, or nothing.
/// @param option  that gives it, e.g. "--step"
[[nodiscard]] std::optional<Warning> stepWarning(double step, double duration, const MotionRates& rates,
                                                 const std::string& option);

}  // namespace vehicle
