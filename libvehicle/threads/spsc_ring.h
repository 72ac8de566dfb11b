#pragma once

// Rows of doubles from one writing thread to one reading thread, without a lock.
//
//            taken_ (the reader's)              put_ (the writer's)
//               v                                  v
//   | free | free | row 3 | row 4 | row 5 | row 6 | free | free |        row i stands at place i % capacity
//
// 1. A row is written with plain stores, then put_ is stored (release); the reader loads put_ (acquire) before it
//    reads the row: it sees the row whole.
// 2. A place is used again only after the writer has loaded a taken_ (acquire) that the reader stored (release)
//    after its last read of that place: no row is overwritten while it is read.
// 3. Each counter has one writer, so no read-modify-write is needed; each side keeps the last value it saw of the
//    other's counter and looks again only when the ring seems full or empty: most calls touch no foreign line.
// 4. With batch > 1 the counters are stored every `batch` rows only: travelling between the cores at every row, they
//    would cost as much as ten steps of a vehicle. 1 and 2 do not ask how often. Whoever finds the ring full or empty
//    stores its own counter first, so the two cannot wait for each other's rest of a batch; the writer calls flush()
//    when it has put its last row.

#include <atomic>
#include <span>
#include <vector>

namespace vehicle {

/// A ring of numbered rows between exactly one writing and one reading thread. Allocates when constructed only.
class SpscRing {
 public:
  /// @param width     doubles of a row, >= 0
  /// @param capacity  rows that may wait, >= 1
  /// @param batch     rows put or taken before the other side hears of them, >= 1
  /// @throws std::invalid_argument otherwise
  SpscRing(int width, long capacity, long batch = 1);

  [[nodiscard]] int width() const { return static_cast<int>(width_); }
  [[nodiscard]] long capacity() const { return capacity_; }

  /// The writer's: whether put() has room. Shows what was put if it has not.
  [[nodiscard]] bool hasRoom() {
    if (put_.own - put_.other < capacity_) return true;
    flush();
    put_.other = taken_.shown.load(std::memory_order_acquire);
    return put_.own - put_.other < capacity_;
  }
  /// The writer's. @param number  of the row, for the reader   @param row  (width)
  /// @return false if the ring is full: nothing was put
  /// @throws std::invalid_argument if the row has another width
  bool put(long number, std::span<const double> row);
  /// The writer's: shows all rows put.
  void flush() { put_.shown.store(put_.own, std::memory_order_release); }
  /// The writer's: rows put.
  [[nodiscard]] long count() const { return put_.own; }

  /// The reader's: the oldest row, or nullptr if there is none; valid until pop().
  [[nodiscard]] const double* front(long& number) {
    if (taken_.own == taken_.other) {
      taken_.shown.store(taken_.own, std::memory_order_release);
      taken_.other = put_.shown.load(std::memory_order_acquire);
      if (taken_.own == taken_.other) return nullptr;
    }
    number = numbers_[taken_.place];
    return rows_.data() + taken_.place * width_;
  }
  /// The reader's: drops the row that front() gave.
  void pop() {
    if (advance(taken_)) taken_.shown.store(taken_.own, std::memory_order_release);
  }

 private:
  struct alignas(64) Counter {
    std::atomic<long> shown{0};
    long own = 0;           // rows; ahead of `shown` by less than a batch
    long other = 0;         // the other side's `shown` as last seen, never ahead of it
    std::size_t place = 0;  // own % capacity
    long left = 1;          // rows until `shown` is stored again
  };

  /// @return whether a batch is full
  bool advance(Counter& counter) const {
    ++counter.own;
    if (++counter.place == numbers_.size()) counter.place = 0;
    if (--counter.left > 0) return false;
    counter.left = batch_;
    return true;
  }

  std::size_t width_;
  long capacity_;
  long batch_;
  std::vector<long> numbers_;  // shape (capacity)
  std::vector<double> rows_;   // shape (capacity x width)
  Counter put_;
  Counter taken_;
};

}  // namespace vehicle
