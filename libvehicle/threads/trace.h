#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "libvehicle/threads/duration_histogram.h"

#if !defined(__x86_64__)
#include <chrono>
#endif

namespace vehicle {

/// Reads the clock of the trace [ticks]: the time-stamp counter where there is one (about 9 ns), else the steady
/// clock. Tracer knows how long a tick is.
inline std::uint64_t stampTicks() {
#if defined(__x86_64__)
  return __builtin_ia32_rdtsc();
#else
  return static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
#endif
}

/// What one thread did for a while, in a step that was traced.
struct Span {
  enum class Kind {
    kCompute,
    kWait
  };
  int thread = 0;
  long step = 0;
  Kind kind = Kind::kCompute;
  double begin_s = 0.0;  // [s] since the team was prepared
  double end_s = 0.0;    // [s]
  int for_whom = -1;     // of a wait: the member waited for
};

/// One thread's waits for another, summed over the traced steps.
struct WaitTotal {
  int thread = 0;
  int for_whom = 0;
  long count = 0;
  double seconds = 0.0;
};

/// All that a tracer saw, as plain data.
struct Trace {
  int threads = 0;
  int every = 1;                   // steps 0, every, 2 every, ... were traced
  std::vector<Span> spans{};       // by thread, then by time
  std::vector<WaitTotal> waits{};  // pairs that occurred, the longest first
  DurationSummary steps{};         // member 0, ALL steps: from the end of one to the end of the next [s]
  long traced_steps = 0;           // of member 0
  long dropped_steps = 0;          // of all members: not traced because the buffer was full
  long stamps = 0;                 // clock readings of all members together
  double stamp_cost = 0.0;         // [s] of one reading, measured in this run
  double overhead = 0.0;           // [s] member 0 spent reading the clock: its stamps x stamp_cost
  double run_seconds = 0.0;        // [s] from the first begin to the last end of a step of member 0
  std::string clock_note{};        // what is wrong with the clock, or empty
};

/// The recorder of one thread. Only that thread writes it while the team runs.
class alignas(64) ThreadTrace {
 public:
  /// @param before  gives its memory away where there is one
  ThreadTrace(int every, std::size_t spans, bool counts_every_step, ThreadTrace* before);

  void beginStep(long step) {
    if (counts_every_step_ && last_end_ == 0) first_begin_ = last_end_ = stamp();
    if (step < next_) return;
    openStep(step);
  }
  /// Work for the steps first .. last-1 together, under the first of them that is traced.
  void beginSteps(long first, long last) {
    const long step = (first + every_ - 1) / every_ * every_;
    if (step < last) beginStep(step);
  }
  void beginWait(int for_whom) {
    if (!open_) return;
    close(Span::Kind::kCompute, -1);
    for_whom_ = for_whom;
  }
  void endWait() {
    if (open_) close(Span::Kind::kWait, for_whom_);
  }
  void endStep(long) {
    if (open_) {
      close(Span::Kind::kCompute, -1);
      open_ = false;
      if (counts_every_step_) countStep(mark_);
    } else if (counts_every_step_) {
      countStep(stamp());
    }
  }

 private:
  friend class Tracer;
  struct Record {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    long step = 0;
    int for_whom = -1;
    Span::Kind kind = Span::Kind::kCompute;
  };

  std::uint64_t stamp() {
    ++stamps_;
    return stampTicks();
  }
  void openStep(long step);
  void close(Span::Kind kind, int for_whom) {
    const std::uint64_t now = stamp();
    if (used_ < records_.size()) records_[used_++] = {mark_, now, step_, for_whom, kind};
    mark_ = now;
  }
  void countStep(std::uint64_t now) {
    steps_.record(now - last_end_);
    last_end_ = now;
  }

  std::vector<Record> records_;  // all of it allocated and touched before the run
  std::size_t used_ = 0;
  std::uint64_t mark_ = 0;  // where the open span begins
  long step_ = 0;
  long next_ = 0;  // the next step to trace
  int every_;
  int for_whom_ = -1;
  bool open_ = false;
  bool counts_every_step_;
  long traced_ = 0;
  long dropped_ = 0;
  long stamps_ = 0;
  std::uint64_t first_begin_ = 0;
  std::uint64_t last_end_ = 0;
  DurationHistogram steps_;
};

/// Watches a team: every n-th step in spans, the duration of every step of member 0 in a histogram.
///
/// Cost: a traced step reads the clock twice, and twice more for each wait that was not over at once; any other step
/// reads it once on member 0 and never on the others. A full buffer drops whole steps and counts them.
class Tracer {
 public:
  /// @param every             >= 1
  /// @param spans_per_thread  >= 1; 48 bytes each
  /// @throws std::invalid_argument otherwise
  explicit Tracer(int every = 16, int spans_per_thread = 1 << 15);

  /// Forgets what was seen and makes room for that many threads; runTeam() calls it.
  void prepare(int threads);
  [[nodiscard]] ThreadTrace& thread(int number) { return threads_[static_cast<std::size_t>(number)]; }

  /// What was seen, after the team has ended. May take 10 ms: the clock is calibrated over that long at least.
  [[nodiscard]] Trace trace() const;

  /// Seconds that one reading of the clock takes here and now: least of 20 rounds of 1000.
  [[nodiscard]] double stampCost() const;

 private:
  struct Instant {
    std::uint64_t ticks = 0;
    double seconds = 0.0;
  };
  static Instant now();

  int every_;
  int spans_per_thread_;
  std::vector<ThreadTrace> threads_{};
  Instant begin_{};
};

}  // namespace vehicle
