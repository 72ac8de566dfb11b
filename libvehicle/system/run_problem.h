#pragma once

#include <span>

#include "libvehicle/system/input.h"
#include "libvehicle/system/schedule.h"
#include "libvehicle/system/system.h"

namespace vehicle {

/// What every run has, whatever integrates it and on however many threads. Looks at all of them: they outlive the run.
struct RunProblem {
  const System& system;
  const Input& input;            // of system.channels() channels, in the system's order
  const Schedule& schedule;      // of that input: where samples are taken
  std::span<const double> x0{};  // (system.size()) the state at the begin
};

}  // namespace vehicle
