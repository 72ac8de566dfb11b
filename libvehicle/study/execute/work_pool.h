#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "libvehicle/study/evaluate/evaluation.h"

namespace vehicle {

/// Threads that evaluate designs, and the queue of what they have finished. One thread, its owner, adds work and takes
/// results.
///
/// Every thread has a deque of ranges of its own. It cuts batches from the front of its first range; when it has none
/// left it steals half of the designs of the thread that has most, from the back, so that thief and owner
/// stay apart and what is left is stolen in few, large pieces.
/// The queue is bounded: where the owner is slower than the threads, they wait, and memory does not grow.
class WorkPool {
 public:
  /// @throws std::runtime_error if the system grants no more threads
  WorkPool(const Evaluator& evaluator, int threads);
  ~WorkPool();  // drops unclaimed work, waits for batches under way
  WorkPool(const WorkPool&) = delete;
  WorkPool& operator=(const WorkPool&) = delete;

  /// Shares the ranges out, equal numbers of designs to each thread, neighbours together.
  /// @param given  as in Workload; stays valid until its designs were taken
  void add(std::span<const DesignSpan> ranges, std::span<const double> given);

  /// The next finished batch; nothing if none is there within `wait`, or at once if no work is left.
  /// @throws what a worker has thrown, after all that was finished has been taken
  std::optional<Batch> take(std::chrono::milliseconds wait);

  /// Gives the storage of a batch back for others.
  void recycle(Batch batch);

  /// Unclaimed work is dropped; what is being evaluated will still be finished.
  void abandon();

  /// Designs added that were neither taken nor dropped.
  [[nodiscard]] std::int64_t outstanding() const;

 private:
  struct Piece {
    DesignSpan range;
    std::span<const double> given;
  };
  // A cache line of its own: threads at work on their own deques do not meet.
  struct alignas(64) Share {
    std::mutex mutex;
    std::deque<Piece> pieces;
    std::atomic<std::int64_t> designs = 0;  // in pieces; thieves look without the lock
  };

  void close();
  void work(std::size_t self);
  bool claim(std::size_t self, Piece& piece);
  bool cutOwn(std::size_t self, Piece& piece);
  bool steal(std::size_t self);
  Piece cutFront(Piece& piece, std::int64_t designs) const;
  Batch spare();
  bool deliver(Batch batch);
  void fail(std::int64_t designs);

  const Evaluator& evaluator_;
  const std::int64_t batch_size_;
  const std::size_t given_;
  const std::size_t most_finished_;
  std::vector<std::unique_ptr<Share>> shares_;  // (threads)
  std::atomic<bool> abandoned_ = false;         // whoever claims work drops it

  mutable std::mutex mutex_;  // of all that follows; locked neither inside nor around a share's
  std::condition_variable work_came_;
  std::condition_variable batch_came_;
  std::condition_variable room_came_;
  std::deque<Batch> finished_;
  std::vector<Batch> spares_;
  std::int64_t outstanding_ = 0;
  std::int64_t unclaimed_ = 0;
  std::exception_ptr failure_;
  bool closing_ = false;

  std::vector<std::jthread> threads_;  // last: they end before what they use
};

}  // namespace vehicle
