#pragma once

#include "libvehicle/integrate/run.h"
#include "libvehicle/partition/schemes/independent_parts.h"
#include "libvehicle/system/run_problem.h"

namespace vehicle {

/// The method rk4_split: bounce and pitch of a flat vehicle whose front and rear are alike, each as a run of its own in
/// (3.4)-(3.7) of docs/theory/vertical.md. On two threads there is no exchange between them; the numbers are the same
/// bits on one and on two, and differ from those of rk4 by rounding.
/// @param problem  of the flat form
/// @param threads  1 or 2; on 1 the caller's own steps both halves in one loop
/// @throws std::invalid_argument  with splitUnsupported(); for more than two threads; and as runRk4()
PartsRun runFlatRk4Split(const RunProblem& problem, FixedStep step, const Observer& observe, int threads = 1,
                         const TeamPolicy& team = {});

}  // namespace vehicle
