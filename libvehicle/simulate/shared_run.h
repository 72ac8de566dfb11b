#pragma once

#include <span>
#include <string>
#include <vector>

#include "libvehicle/partition/choose.h"
#include "libvehicle/simulate/methods.h"
#include "libvehicle/threads/team.h"

namespace vehicle {

/// How threads are to share the work of one run. The names fit the method and the form (threadsMisfit).
struct ThreadRequest {
  int threads = 1;      // 0: chosen
  std::string scheme;   // empty: serial on 1 thread, else chosen
  EquationMap map = EquationMap::kAuto;
  TeamChoice team;      // its own number of threads is not read
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
  TeamReport team;    // no members where the caller's own thread did it
  std::vector<ThreadWork> work;  // (members)
  Decision decision;  // its reason is empty where nothing was to be chosen
};

/// runMethod() on as many threads as asked for, or as many as are fastest: the same bits, sooner.
/// @throws std::invalid_argument  for a vehicle that cannot be shared so (fewer equations than threads, front and rear
///                                that differ for the split methods), and as runMethod()
[[nodiscard]] SharedRun runShared(const std::string& method, const System& system, const Input& input,
                                  const Schedule& schedule, const MethodSettings& settings, std::span<const double> x0,
                                  const Observer& observe, const ThreadRequest& request);

}  // namespace vehicle
