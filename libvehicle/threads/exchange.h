#pragma once

// How values pass between the threads of a team without a lock.
//
//            slot of even epochs                     slot of odd epochs
//   owner   | epoch | v0 v1 v2 v3 v4 v5 v6 | v7 ..  | epoch | v0 v1 v2 v3 v4 v5 v6 | v7 ..
//            <-------- 64 bytes ---------->          the owner writes, everybody else only reads
//
// An epoch e is one exchange. Thread i fills slot(i, e) with plain stores, publishes e, then awaits e of each thread
// j that it reads and reads slot(j, e), before it begins to fill slot(i, e + 1). Waiting is symmetric: if i awaits
// j, then j awaits i, at the same epochs.
//
// 1. Delivery. The values are written before publish() stores e into the counter (release). await() loads the
//    counter (acquire) until it holds e. The load that saw e synchronises with that store, so what was written
//    before it is visible after it: the values read are those of epoch e, whole.
// 2. No overwriting. Thread i may touch slot(i, e) again only for epoch e + 2, after it awaited e + 1 of every j
//    that reads it (symmetry). j published e + 1 after its last read of slot(i, e) (program order, release), and i
//    saw that e + 1 (acquire). So each read of epoch e happens before the first write of epoch e + 2, and two slots
//    by parity are enough. One would not be: i writes e + 1 while j may still read e.
// 3. Hence plain doubles are no data race: by 1 and 2 every write and every read of a value are ordered by
//    happens-before. Only the counters are atomic; the thread sanitizer sees both arrows and stays silent.
// 4. No fence and no sequential consistency: neither argument compares the order of two different counters as seen
//    by a third thread. Each arrow is one store and the load that saw it. On x86 both are plain moves.
// 5. Threads that do not wait for each other may be any number of epochs apart; a counter never skips an epoch of a
//    thread that waits for it, by 2. A counter ahead of the epoch asked for means that waiting was not symmetric:
//    an assertion holds this in the release build too.
// 6. A slot begins with its counter in the line of its first seven values: one line travels, once. Slots start on
//    lines of their own and owners 128 bytes apart, because some cores fetch lines in pairs.

#include <atomic>
#include <cassert>
#include <cstddef>
#include <memory>
#include <new>
#include <vector>

#include "libvehicle/threads/team.h"

namespace vehicle {

/// One block of doubles per thread, shown to the others once an epoch; epochs count 1, 2, 3, ...
///
/// Owns its memory; constructing allocates, exchanging never does. Slots start at epoch 0 with zeros.
class Exchange {
 public:
  /// @param values_of_thread  doubles that thread i shows per epoch, >= 0 each
  /// @throws std::invalid_argument for no thread or a negative number
  explicit Exchange(const std::vector<int>& values_of_thread);

  [[nodiscard]] int threads() const { return static_cast<int>(owners_.size()); }
  [[nodiscard]] int values(int owner) const { return owners_[static_cast<std::size_t>(owner)].values; }

  /// Where the owner writes its values of that epoch, before publish().
  [[nodiscard]] double* slot(int owner, long epoch) { return line(owner, epoch).values(); }

  /// Shows slot(me, epoch) to the others. From here on it must not be written before epoch + 2.
  void publish(Member& me, long epoch) {
    me.injectDelay(epoch);
    line(me.number(), epoch).epoch.store(epoch, std::memory_order_release);
    me.ring();
  }

  /// The values of owner at that epoch; valid until `me` publishes epoch + 1.
  [[nodiscard]] const double* await(Member& me, int owner, long epoch) {
    me.injectDelay(epoch);
    Line& shown = line(owner, epoch);
    long seen = 0;
    me.wait([&] { return (seen = shown.epoch.load(std::memory_order_acquire)) >= epoch; }, owner,
            [&] { return whoWantsCore(me, epoch); });
    assert(seen == epoch);  // else the owner did not wait for `me`
    return shown.values();
  }

 private:
  struct alignas(64) Line {
    std::atomic<long> epoch{0};
    double* values() { return reinterpret_cast<double*>(reinterpret_cast<std::byte*>(this) + sizeof(epoch)); }
  };
  static_assert(std::atomic<long>::is_always_lock_free && sizeof(std::atomic<long>) == sizeof(double));

  struct Owner {
    std::byte* begin = nullptr;
    std::size_t slot_bytes = 0;
    int values = 0;
  };
  struct Free {
    void operator()(std::byte* memory) const { ::operator delete (memory, std::align_val_t{kApart}); }
  };
  static constexpr std::size_t kApart = 128;  // [bytes] between owners

  Line& line(int owner, long epoch) {
    const Owner& of = owners_[static_cast<std::size_t>(owner)];
    return *std::launder(reinterpret_cast<Line*>(of.begin + static_cast<std::size_t>(epoch & 1) * of.slot_bytes));
  }

  // A thread that runs in turn with this one and has not shown the epoch yet keeps everybody waiting: it gets the
  // core at once, whoever is waited for. Else the epoch is on its way from another core and a pause is shorter than a
  // change of threads. Measured with 4 threads on 2 cores: one change an exchange, 1.4 us against 2.1 us without.
  int whoWantsCore(const Member& me, long epoch) {
    const int stride = me.stride();
    if (stride == 0) return Member::kNobody;
    for (int other = me.number() % stride; other < threads(); other += stride) {
      if (line(other, epoch).epoch.load(std::memory_order_relaxed) < epoch && other != me.number()) return other;
    }
    return Member::kNobody;
  }

  std::unique_ptr<std::byte, Free> memory_;
  std::vector<Owner> owners_;
};

}  // namespace vehicle
