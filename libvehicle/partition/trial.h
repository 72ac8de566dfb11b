#pragma once

#include <functional>

#include "libvehicle/partition/choose.h"

namespace vehicle {

/// The first `steps` steps of a run as a run of its own.
struct Trial {
  Input input;
  Schedule schedule;
  long steps;
};

/// @param steps  wanted; at least 8, and no more than the run has
[[nodiscard]] Trial trialOf(const TuningProblem& problem, long steps);

/// [s] a step by that way, without the start of its threads.
/// @param now    [s] a clock
/// @param limit  [s] a way that has not come to the end by then is broken off: it is told by what it has done
[[nodiscard]] double timeOf(const Way& way, const Trial& trial, double limit,
                            const std::function<double()>& now);

}  // namespace vehicle
