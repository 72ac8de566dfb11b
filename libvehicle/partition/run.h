#pragma once

#include <span>
#include <vector>

#include "libvehicle/integrate/run.h"
#include "libvehicle/partition/scheme.h"
#include "libvehicle/threads/team.h"

namespace vehicle {

/// How a run is shared among threads.
struct PartitionChoice {
  Scheme scheme = Scheme::kStages;
  EquationMap map = EquationMap::kAuto;  // stages, halo, rows
  TeamChoice team;
};

/// What a shared run cost and who did what.
struct PartitionRun {
  Statistics statistics;
  TeamReport team;
  std::vector<std::vector<int>> shares;  // (threads) equations in cut order; one share of all where they are not shared
};

/// One run on a team of threads: the bits of runRk4() (serial, stages, halo, pipeline) or runExact() (rows) for every
/// number of threads and every map. State and channels are in the System's order; the observer is called on member 0,
/// in order, while the caller waits.
///
/// An observer that returns false, a state that is no longer finite, or an exception of the observer ends the run on
/// all threads; exceptions reach the caller.
/// @throws std::invalid_argument  the system cannot be cut, the scheme does not fit it, or the threads, the map or the
///                                team do not fit; and as runRk4() and runExact()
/// @throws std::runtime_error     as runRk4() and runExact()
PartitionRun runPartitioned(const System& system, const Input& input, const Schedule& schedule, FixedStep step,
                            std::span<const double> x0, const Observer& observe, const PartitionChoice& choice);

}  // namespace vehicle
