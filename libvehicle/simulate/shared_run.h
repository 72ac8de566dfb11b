#pragma once

#include <string>
#include <vector>

#include "libvehicle/partition/choose.h"
#include "libvehicle/simulate/methods.h"
#include "libvehicle/system/run_problem.h"
#include "libvehicle/threads/team.h"

namespace vehicle {

/// How threads are to share the work of one run, and what kind of team they are. Fits the method and the form
/// (threadsUnsupported).
struct ThreadRequest {
  Sharing sharing;
  TeamPolicy team;
};

/// What one thread of a shared run computes in every step.
struct ThreadWork {
  int equations = 0;   // halves of a split vehicle count as the two they hold
  std::string what;    // "carbody bounce (2), carbody pitch (3)"; of many neighbours the first and the last
};

/// What a run made, and on whom.
struct SharedRun {
  Statistics statistics;
  Scheme scheme = Scheme::kSerial;
  int threads = 1;
  TeamReport team{};               // no members where the caller's own thread did it
  std::vector<ThreadWork> work{};  // (members)
  Decision decision{};             // its reason is empty where nothing was to be chosen
};

/// A run of that method on as many threads as asked for, or as many as are fastest: the same bits, sooner.
/// @throws std::invalid_argument  for a vehicle that cannot be shared so (fewer equations than threads, front and rear
///                                that differ for the split methods), and as method.make()
[[nodiscard]] SharedRun runShared(const Method& method, const RunProblem& problem, const MethodSettings& settings,
                                  const Observer& observe, const ThreadRequest& request);

}  // namespace vehicle
