#pragma once

#include <climits>
#include <string>
#include <vector>

namespace vehicle {

/// How a thread waits for another: it looks again and again, and gives way more and more.
///
/// Nobody is notified, so no wake-up can be lost and whoever publishes pays nothing; the price is a late look, by
/// at most one pause, one turn of the scheduler or one sleep.
struct Waiting {
  int pauses = 0;      // looks with one pause instruction between; kForever: never gives the core away
  int yields = 0;      // then looks with one sched_yield between; kForever: never sleeps
  double sleep = 0.0;  // [s] > 0: then looks with a sleep of this length between; 0: only where yields == kForever

  static constexpr int kForever = INT_MAX;
};

/// The policy for that many threads on that many cores of the affinity mask: long pauses where every thread has a
/// core, an early yield where they take turns, and in both cases sleep once the other must have lost its core.
/// @throws std::invalid_argument unless threads >= 1 and cores >= 1
[[nodiscard]] Waiting waitingFor(int threads, int cores);

/// auto | spin | yield | sleep
[[nodiscard]] const std::vector<std::string>& waitingNames();

/// @throws std::invalid_argument for an unknown name, and for "spin" with more threads than cores: the thread that
///         is waited for could not run until the scheduler takes the core away, a step of microseconds would last
///         milliseconds
[[nodiscard]] Waiting waitingNamed(const std::string& name, int threads, int cores);

/// A policy without endless pauses or yields: sooner or later it sleeps, so that a thread of real-time priority
/// leaves its core to others.
[[nodiscard]] bool givesWay(const Waiting& waiting);

/// Tells the core that this is a loop of looks: the sibling hyper-thread gets the units, the loop ends sooner.
inline void pauseCore() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

/// The turns of one wait, in the order of its policy.
class Patience {
 public:
  explicit Patience(const Waiting& waiting) : pauses_(waiting.pauses), waiting_(&waiting) {}

  /// Call between two looks.
  /// @param core_is_wanted  what is waited for may need this very core: no pause, it is given away at once
  void turn(bool core_is_wanted = false) {
    if (pauses_ > 0 && !core_is_wanted) {
      if (pauses_ != Waiting::kForever) --pauses_;
      pauseCore();
    } else {
      giveWay();
    }
  }

 private:
  void giveWay();

  int pauses_;
  int yielded_ = 0;
  const Waiting* waiting_;
};

}  // namespace vehicle
