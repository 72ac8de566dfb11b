#pragma once

#include <string>
#include <vector>

namespace vehicle {

/// What the kernel counted for one thread; -1 where it would not tell.
///
/// Sources: CLOCK_THREAD_CPUTIME_ID for the run time, getrusage(RUSAGE_THREAD) for the switches,
/// /proc/self/task/<tid>/ schedstat (waited to run), stat (blocked on a device, field 42) and sched (migrations). A
/// container may hide any of the files.
struct ThreadUsage {
  double wall = -1.0;                // [s] since the usage before was taken
  double running = -1.0;             // [s] on a core
  double preempted = -1.0;           // [s] ready to run, but on no core
  double blocked_io = -1.0;          // [s] waiting for a device
  long voluntary = -1;               // context switches: gave its core away (sleep, yield, lock)
  long involuntary = -1;             // context switches: its core was taken
  long migrations = -1;              // moves to another core
  std::vector<std::string> missing;  // what is not available and why, one line each
};

/// Usage of the calling thread since it began; wall is the monotonic clock.
[[nodiscard]] ThreadUsage usageOfThisThread();

/// What was used between two looks of the same thread; a figure that either lacks stays -1.
[[nodiscard]] ThreadUsage between(const ThreadUsage& begin, const ThreadUsage& end);

}  // namespace vehicle
