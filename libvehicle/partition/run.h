#pragma once

#include <vector>

#include "libvehicle/integrate/step_walk.h"
#include "libvehicle/partition/scheme.h"
#include "libvehicle/partition/step_costs.h"
#include "libvehicle/system/run_problem.h"
#include "libvehicle/threads/team.h"

namespace vehicle {

/// What a shared run cost and who did what.
struct PartitionRun {
  Statistics statistics;
  TeamReport team;
  std::vector<std::vector<int>> shares;  // (threads) equations in cut order; one share of all where they are not shared
};

/// One run on a team of threads: the bits of makeRk4() for every number of threads and every map. State and channels are
/// in the System's order; the observer is called on member 0, in order, while the caller waits.
///
/// An observer that returns false, a state that is no longer finite, or an exception of the observer ends the run on
/// all threads; exceptions reach the caller.
/// @param sharing  no scheme: serial
/// @throws std::invalid_argument  the system cannot be cut, the scheme does not fit it, or the threads, the map or the
///                                team do not fit; and as makeRk4()
/// @throws std::runtime_error     as makeRk4()
PartitionRun runPartitioned(const RunProblem& problem, FixedStep step, const Observer& observe, const Sharing& sharing,
                            const TeamPolicy& team = {});

/// [s] a step of that scheme on so many threads takes at best: what it must compute and how often it must exchange.
/// @param set      equations of the system, or nullptr where it cannot be cut
/// @param sharing  with a scheme
[[nodiscard]] double bestStep(const StepCosts& costs, const EquationSet* set, const Sharing& sharing);

}  // namespace vehicle
