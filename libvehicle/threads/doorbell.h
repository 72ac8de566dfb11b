#pragma once

// How a member that publishes wakes those that block until it does.
//
// 1. Who blocks adds itself to `sleepers_`, reads `rings_`, looks once more, and sleeps in the kernel as long as
//    `rings_` is what it read. Who publishes stores its value first, then looks at `sleepers_`; where there is one, it
//    raises `rings_` and wakes all.
// 2. A ring after the reading of `rings_` is never lost: the kernel compares the word before it lets the thread sleep.
// 3. The store of the value and the look at `sleepers_` may pass each other, as no fence stands between them: one costs
//    as much as a step of a small vehicle. A ring can therefore be missed in the nanoseconds in which somebody goes to
//    sleep; the time limit of the sleep makes up for it. It is a matter of time and never of values. Where both stand
//    on one core nothing passes: the core sees its own stores in order, and a change of threads is a fence.
// 4. Values are delivered by whatever `ready` looks at (acquire), as without the bell: nothing here orders them. The
//    two words are atomic and no plain data is shared, so the thread sanitizer has nothing to report.
// 5. One bell a member, rung by that member alone: while nobody blocks, its line stays in the caches of its core and
//    publishing costs one load.

#include <atomic>
#include <cstdint>

namespace vehicle {

/// Wakes threads that block for one member of a team.
class alignas(64) Doorbell {
 public:
  /// Sleeps until the bell rings, unless ready() is true by then; it may return early.
  /// @param most  [s] at most that long
  template <class Ready>
  void await(Ready& ready, double most) {
    sleepers_.fetch_add(1, std::memory_order_seq_cst);
    const std::uint32_t heard = rings_.load(std::memory_order_acquire);
    if (!ready()) sleep(heard, most);
    sleepers_.fetch_sub(1, std::memory_order_relaxed);
  }

  /// After something was published.
  void ring() {
    if (sleepers_.load(std::memory_order_relaxed) > 0) [[unlikely]]
      wake();
  }

 private:
  void sleep(std::uint32_t heard, double most);
  void wake();

  std::atomic<std::uint32_t> rings_{0};
  std::atomic<int> sleepers_{0};
};

}  // namespace vehicle
