#pragma once

#include <vector>

namespace vehicle {

/// Processing units that the calling thread may run on, in the order in which a team should take them: one of every
/// physical core before the second hyper-thread of any. Never empty. Thread i of a team stands on entry i % size.
///
/// The affinity mask (taskset, a container's cpuset) decides which; hwloc tells which of them share a core. Where
/// hwloc knows nothing, the order is that of the mask.
[[nodiscard]] std::vector<int> allowedCores();

/// How many that are, without asking hwloc: its first answer takes milliseconds, longer than many a run.
[[nodiscard]] int allowedCoreCount();

}  // namespace vehicle
