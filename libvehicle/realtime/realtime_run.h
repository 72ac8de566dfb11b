#pragma once

#include <string>
#include <vector>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/model/compiled_model.h"
#include "libvehicle/realtime/realtime.h"
#include "libvehicle/simulate/simulate.h"

namespace vehicle {

/// What a run by the clock was and how it went.
struct RealtimeRun {
  RealtimeReport report;
  std::string form;
  double speed = 0.0;         // [m/s]
  long steps = 0;             // asked for: the scenario's duration in whole periods
  long states_read = 0;       // taken from the ring of states by the feeding thread
  std::vector<double> state;  // after the last step, in the form's order
  Warnings warnings;          // UNSTABLE_STEP, COARSE_STEP of the period
  bool same_bits = false;     // the last state is, bit for bit, that of runRk4() with that step
};

/// A scenario as a partner in a rig sees it: one period of rk4 is released every `period` of true time, on a thread of
/// its own; the calling thread plays the rail into a ring, ahead by up to 50 ms, and reads the states from another.
/// The steps are those of a run without a clock by rk4 with that step: a period with breakpoints of the rail inside is
/// several steps, which end on them.
/// @param choice    form and speed are read; priority and pinning of its team, too
/// @param period    [s] 1e-6 .. 3600
/// @param progress  asked a few hundred times a second; false ends the run after the step that is under way
/// @throws InvalidInput           the scenario is wrong, alone or beside the vehicle, or the form does not fit
/// @throws std::invalid_argument  a period that is out of range, or longer than the scenario; a form or speed that
///                                is wrong
/// @throws RunFailed              a state is no longer finite
[[nodiscard]] RealtimeRun simulateRealtime(const CompiledModel& model, const Scenario& scenario,
                                           const RunChoice& choice, double period, const Progress& progress = {});

}  // namespace vehicle
