#pragma once

// How the state reaches the observer while the threads go on.
//
//   pauses ->     8     9    10    11
//   thread 0   | out | out | in  |     |     member 0 has shown 9 and is about to show 10
//   thread 1   | out | out | in  | in  |     a step ahead
//   thread 2   | out | out |     |     |     member 0 waits for it before it shows 10
//
// 1. At every pause of the walk (step_walk.h) each thread copies its own part of the state into the slot of that
//    pause and raises its counter (release). Member 0 shows a pause when the counters of all have passed it (acquire),
//    so the slot is whole, and then raises `shown_`.
// 2. A slot is written again for the pause `slots` later, by a thread that saw `shown_` pass the earlier one
//    (acquire): what the observer read happens before it. So plain doubles are no data race, as in exchange.h.
// 3. Nobody waits for the observer before the ring is full, and member 0 waits for nobody before that either: it shows
//    what is complete and steps on.
// 4. A thread judges whether its own part is finite; member 0 throws the failure of the serial run, at the same pause.

#include <atomic>
#include <span>
#include <vector>

#include "libvehicle/integrate/step_walk.h"
#include "libvehicle/system/run_problem.h"
#include "libvehicle/threads/team.h"

namespace vehicle {

/// The last few states of a run on their way from the threads that compute them to the observer of member 0.
class SampleRing {
 public:
  static constexpr int kMostSlots = 8;

  /// @param method   named by a failure
  /// @param states   n of the system
  /// @param observe  looked at; must outlive the ring
  SampleRing(const char* method, int threads, int states, const Observer& observe);

  /// Member 0 before its first step: shows the start. False if the observer ends the run there.
  bool begin(Member& me, const RunProblem& problem);

  /// Every member at every pause, in order.
  /// @param fill  fill(double* x): writes the member's own entries of the state, in the System's order, and returns
  ///              whether all of them are finite
  /// @return false if the run ends here
  /// @throws std::runtime_error  on member 0, if a state is no longer finite
  template <class Fill>
  bool show(Member& me, const StepPause& here, Fill fill) {
    const long pause = begun(me);
    if (me.number() == 0) note(me, pause, here);
    makeRoom(me, pause);
    if (stopped_.load(std::memory_order_relaxed)) return false;
    const bool finite = fill(slot(pause));
    return done(me, pause, finite);
  }

  /// Member 0 after its last step: shows what is left.
  void finish(Member& me);

  /// What member 0 has shown: steps and whether the observer stopped the run. Valid when the team has ended.
  [[nodiscard]] const Statistics& statistics() const { return statistics_; }

 private:
  struct alignas(64) Line {
    std::atomic<long> written{0};  // pauses
    bool finite[kMostSlots] = {};
  };

  double* slot(long pause) { return states_.data() + static_cast<std::size_t>(pause % slots_) * stride_; }
  long begun(const Member& me) const {
    return lines_[static_cast<std::size_t>(me.number())].written.load(std::memory_order_relaxed);
  }
  void note(Member& me, long pause, const StepPause& here);
  void makeRoom(Member& me, long pause);
  bool done(Member& me, long pause, bool finite);
  bool complete(long pause) const;
  void showNext(Member& me);

  const char* method_;
  const Observer& observe_;
  std::size_t size_;
  std::size_t stride_;
  int slots_;
  std::vector<double> states_;  // (slots x n), each on lines of its own
  std::vector<Line> lines_;     // (threads)
  alignas(64) std::atomic<long> shown_{0};
  std::atomic<bool> stopped_{false};
  alignas(64) StepPause notes_[kMostSlots];  // member 0's own
  Statistics statistics_;
};

}  // namespace vehicle
