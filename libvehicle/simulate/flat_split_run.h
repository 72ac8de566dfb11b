#pragma once

#include <memory>
#include <string>

#include "libvehicle/integrate/integrator.h"
#include "libvehicle/integrate/step_walk.h"
#include "libvehicle/partition/schemes/independent_parts.h"
#include "libvehicle/system/run_problem.h"

namespace vehicle {

// The method rk4_split: bounce and pitch of a flat vehicle whose front and rear are alike, each as a run of its own in
// (3.4)-(3.7) of docs/theory/vertical.md.

/// Why it cannot run this system ("rk4_split: ... the rear one = 9500 kg; take rk4"); empty if it can.
[[nodiscard]] std::string splitUnsupportedBy(const System& system);

/// Both halves in one loop.
/// @throws std::invalid_argument  with splitUnsupportedBy(), and as makeRk4()
[[nodiscard]] std::unique_ptr<Integrator> makeFlatRk4Split(const RunProblem& problem, FixedStep step);

/// Each half on a thread, without exchange between them; the same bits, which differ from those of rk4 by rounding.
/// @param threads  1 or 2
/// @throws std::invalid_argument  for more than two threads, and as makeFlatRk4Split()
PartsRun runFlatRk4Split(const RunProblem& problem, FixedStep step, const Observer& observe, int threads,
                         const TeamPolicy& team = {});

}  // namespace vehicle
