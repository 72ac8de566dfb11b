#pragma once

#include <vector>

#include "libvehicle/threads/trace.h"

namespace vehicle {

/// What the traced steps of member 0 waited for in the end: the chain of work that ends with a step.
///
/// The walk goes backwards from the end of the step. On a compute span the time belongs to that thread; a wait leads to
/// the thread that was waited for, at the moment at which it had shown its values. It had when it began to wait
/// itself; the time from there to the end of the wait is delivery: the line on its way, and a look that came late. A
/// wait for values that had been shown before it began is delivery as a whole.
struct CriticalPath {
  struct HandOver {
    int from = 0;  // worked last
    int to = 0;    // waited for it
    long count = 0;
  };
  long steps = 0;                     // traced steps of member 0
  double seconds = 0.0;               // [s] their time, the sum of what follows
  std::vector<double> computing{};    // [s] of each thread, shape (threads)
  double delivery = 0.0;              // [s] from shown to seen
  std::vector<HandOver> handovers{};  // pairs that occurred, the most frequent first
};
[[nodiscard]] CriticalPath criticalPathOf(const Trace& trace);

}  // namespace vehicle
