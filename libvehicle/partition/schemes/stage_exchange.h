#pragma once

// The source paper's design: every thread its equations, the state exchanged at every stage.
//
//   stage    1              2              3              4
//   thread 0 f ->s2 row await f ->s3  await f ->s4 row await f ->x  await
//   thread 1 f ->s2 row await f ->s3  await f ->s4 row await f ->x  await
//              \_____________/  one line travels each way
//
// 1. A stage's arguments (q, q') of a thread's own equations go to its neighbours in one cache line with the epoch of
//    that stage: four epochs a step. A thread awaits those threads only whose equations are neighbours of its own.
// 2. The way of that line, 35 to 215 ns, four times, is the floor of a step. What needs no neighbour is done while the
//    line is on its way: the rows of the rail (stage_rows.h), the weighted sums, the samples.
// 3. In the map `paper` the rail is the work of one thread. It fills the rows of the next Input::kBlock samples while
//    the others read those before. No flag guards them: the rows of block b + 1 are written before an epoch of block b
//    that every reader awaits, and the place of block b - 1 is written again after epochs of block b that every
//    reader published when it was done with b - 1. All others must therefore be neighbours of that thread, which the
//    one vehicle of this map grants.

#include "libvehicle/integrate/step_walk.h"
#include "libvehicle/partition/run.h"
#include "libvehicle/partition/step_costs.h"

namespace vehicle {

/// Rk4 with the state exchanged at every stage, the bits of makeRk4().
/// @throws as runPartitioned()
PartitionRun runStageExchange(const RunProblem& problem, FixedStep step, const Observer& observe,
                              const Sharing& sharing, const TeamPolicy& team);

/// [s] a step takes at best.
[[nodiscard]] double stageExchangeStep(const StepCosts& costs, const EquationSet& set, const Sharing& sharing);

}  // namespace vehicle
