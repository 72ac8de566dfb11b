#pragma once

#include <atomic>
#include <functional>
#include <limits>
#include <span>
#include <string>

#include "libvehicle/threads/duration_histogram.h"
#include "libvehicle/threads/spsc_ring.h"
#include "libvehicle/threads/team.h"

namespace vehicle {

/// Moves the state over one period.
/// @param row  the input, as it came through RealtimeRows::input; nullptr in a run without inputs
/// @param x    (n), updated in place
using RealtimeStep = std::function<void(const double* row, double* x)>;

/// Makes of the newest row what is given to a step whose own has not come; both have the same length.
using HoldRow = std::function<void(std::span<const double> newest, std::span<double> held)>;

/// When steps are released: step after step, one every period, until that many are done or somebody stops it.
struct ReleaseClock {
  double period = 1e-3;                           // [s] 1e-6 .. 3600
  long steps = std::numeric_limits<long>::max();  // >= 0
};

/// What is asked of the system; what was got stands in the report.
struct RealtimeChoice {
  enum class Memory {
    kPaged,   // pages may be swapped out, the first touch of one costs a fault
    kLocked,  // mlockall for the time of the run
  };
  Priority priority = Priority::kFifo;  // only with a core to spare
  Pinning pinning = Pinning::kCores;
  Memory memory = Memory::kLocked;
  const std::atomic<bool>* stop = nullptr;  // where set: looked at before every step, at least every 50 ms
};

/// How a real-time run went. Releases lie at begin + k period; the deadline of a step is the release after its own.
struct RealtimeReport {
  long steps = 0;
  bool stopped = false;        // by choice.stop
  long deadline_misses = 0;    // steps that ended after their deadline
  long skipped_releases = 0;   // releases that passed meanwhile: no step was made up for, the run is that much longer
  long inputs_held = 0;        // steps whose input was not there: that of the newest row was held
  long inputs_late = 0;        // rows that came after their step had begun
  long outputs_lost = 0;       // states that the output ring had no room for
  DurationSummary wake_up{};   // from a release to the moment the thread ran [s]
  DurationSummary step{};      // from there to the end of the step, exchange of rows included [s]
  DurationSummary response{};  // from a release to the end of its step [s]
  bool memory_locked = false;
  std::string memory_note{};  // why not, or empty
  MemberReport thread{};      // core, priority and usage of the thread that stepped
};

/// How rows come and go; nothing: a run without inputs, or states that nobody looks at.
struct RealtimeRows {
  SpscRing* input = nullptr;   // read by the stepping thread alone; its rows are a matter between sender and step
  SpscRing* output = nullptr;  // width n, written by it alone
  /// Empty: rows are the input at the begin, middle and end of a step, one after the other, (3 x width); held is three
  /// times the end.
  HoldRow hold{};
};

/// Steps released by the monotonic clock, for models that run against hardware. Runs on a thread of its own; the
/// calling thread waits for the end.
///
/// Inputs: row i of `input` is for step i (counted from 0), numbers rise. A step whose row has not come is given what
/// `hold` makes of the newest (zeros before the first). With every row in time the states are, bit for bit, those of
/// the same steps made without a clock.
/// Outputs: after step i the state is put into `output` under number i + 1; a full ring loses it and is not
/// waited for.
/// A step that ends late is never caught up: the next one begins at the next release that is still to come.
///
/// @param x  (n) state at the begin, and at the end of the last step on return
/// @throws std::invalid_argument for a period, a number of steps, a width or an x that does not fit
/// @throws std::runtime_error    if a state is no longer finite, and what the step throws
RealtimeReport runRealtime(const RealtimeStep& step, std::span<double> x, ReleaseClock clock,
                           const RealtimeChoice& choice, RealtimeRows rows);

}  // namespace vehicle
