#pragma once

#include <climits>
#include <string>
#include <vector>

namespace vehicle {

/// How a thread waits for another, by name.
enum class WaitingKind {
  kAuto,   // "auto"   as waitingFor() has it for the threads and cores at hand
  kSpin,   // "spin"   pauses without end
  kYield,  // "yield"  a few pauses, then yields without end
  kSleep,  // "sleep"  a few pauses, then it blocks
};
[[nodiscard]] const std::vector<std::string>& waitingNames();
[[nodiscard]] const char* nameOf(WaitingKind kind);
/// @throws std::invalid_argument for a name that does not exist
[[nodiscard]] WaitingKind waitingKindOf(const std::string& name);

/// How a thread waits for another: it looks again and again, gives way more and more, and blocks in the end.
///
/// Looks alone would do: a wake-up that is missed costs one sleep and no value (doorbell.h).
struct Waiting {
  int pauses = 0;      // looks with one pause instruction between; kForever: never gives the core away
  int yields = 0;      // then looks with one sched_yield between; kForever: never blocks
  double sleep = 0.0;  // [s] > 0: then it blocks until it is rung for, at most this long at a time; 0: only where
                       // yields == kForever

  static constexpr int kForever = INT_MAX;
};

/// The policy of that kind for that many threads on that many cores of the affinity mask. kAuto: long pauses where
/// every thread has a core, an early yield where they take turns, and in both cases it blocks once the other must have
/// lost its core, or once a yield has shown that somebody else wants this one.
/// @throws std::invalid_argument unless threads >= 1 and cores >= 1, and for kSpin with more threads than cores: the
///         thread that is waited for could not run until the scheduler takes the core away, a step of microseconds
///         would last milliseconds
[[nodiscard]] Waiting waitingFor(WaitingKind kind, int threads, int cores);

/// A policy without endless pauses or yields: sooner or later it sleeps, so that a thread of real-time priority
/// leaves its core to others.
[[nodiscard]] bool givesWay(const Waiting& waiting);

/// Reports to the core that this is a loop of looks: the sibling hyper-thread gets the units, the loop ends sooner.
inline void pauseCore() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

/// Whether a thread's yields go to threads of its own team. One that lasts long went to somebody else, for a whole
/// slice of the scheduler (3 ms), as will the next ones; who blocks gets the core back the moment it is woken.
class YieldMemory {
 public:
  static constexpr int kWaitsWithout = 2000;  // the slice, shared out among them, is microseconds each

  /// At the begin of every wait.
  void beginWait() {
    if (waits_without_ > 0) --waits_without_;
  }
  [[nodiscard]] bool mayYield() const { return waits_without_ == 0; }
  void yield();

 private:
  int waits_without_ = 0;
};

/// The turns of one wait, in the order of its policy.
class Patience {
 public:
  Patience(const Waiting& waiting, YieldMemory& memory)
      : pauses_(waiting.pauses), waiting_(&waiting), memory_(&memory) {
    memory.beginWait();
    // Who blocks may leave the core idle, and to wake an idle core takes far longer than a turn.
    if (!memory.mayYield() && pauses_ < kPausesBeforeBlocking) pauses_ = kPausesBeforeBlocking;
  }
  static constexpr int kPausesBeforeBlocking = 2000;  // about 60 us

  /// Call between two looks.
  /// @param core_is_wanted  what is waited for may need this very core: no pause, it is given away at once
  /// @return false: it is time to block, for waiting.sleep at most
  [[nodiscard]] bool turn(bool core_is_wanted = false) {
    if (pauses_ > 0 && !core_is_wanted) {
      if (pauses_ != Waiting::kForever) --pauses_;
      pauseCore();
      return true;
    }
    return giveWay();
  }

 private:
  bool giveWay();

  int pauses_;
  int yielded_ = 0;
  const Waiting* waiting_;
  YieldMemory* memory_;
};

}  // namespace vehicle
