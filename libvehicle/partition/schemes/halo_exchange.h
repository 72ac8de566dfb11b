#pragma once

// One exchange a step: every thread computes its own run of equations and, redundantly, as many of its neighbours'
// as its four stages read.
//
//   thread 0  ==================####          = own, # redundant: 3 neighbourhoods at stage 1, 2 at stage 2, 1 at 3
//   thread 1                ####===========####
//   thread 2                             ####==================
//
// The state that stage 1 reads reaches four neighbourhoods beyond a run; it is all that threads show each other, at
// the end of a step. Each equation gives the same bits whoever computes it, so redundancy costs time and no bit.
// A thread shows its border as soon as its last block is done, and looks for a neighbour's before the first block
// that reads it: what lies between is time to travel.

#include "libvehicle/partition/run.h"

namespace vehicle {

/// Rk4 with redundant halo, the bits of makeRk4(). On one thread it is makeBlockedRk4().
/// @throws as runPartitioned()
PartitionRun runHaloExchange(const RunProblem& problem, FixedStep step, const Observer& observe, const Sharing& sharing,
                             const TeamPolicy& team);

/// [s] a step takes at best, redundant equations included.
[[nodiscard]] double haloExchangeStep(const StepCosts& costs, const EquationSet& set, const Sharing& sharing);

}  // namespace vehicle
