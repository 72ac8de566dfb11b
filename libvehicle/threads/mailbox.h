#pragma once

// One thread puts rows of doubles in, one other takes them out; neither ever waits or locks.
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

#include <atomic>
#include <span>
#include <vector>

namespace vehicle {

/// A ring of numbered rows between exactly one writing and one reading thread. Allocates when constructed only.
class Mailbox {
 public:
  /// @param width     doubles of a row, >= 0
  /// @param capacity  rows that may wait, >= 1
  /// @throws std::invalid_argument otherwise
  Mailbox(int width, int capacity);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int capacity() const { return static_cast<int>(capacity_); }

  /// The writer's. @param number  of the row, for the reader   @param row  (width)
  /// @return false if the ring is full: nothing was put
  /// @throws std::invalid_argument if the row has another width
  bool put(long number, std::span<const double> row);

  /// The reader's: the oldest row, or nullptr if there is none; valid until pop().
  [[nodiscard]] const double* front(long& number);
  /// The reader's: drops the row that front() gave.
  void pop();

 private:
  struct alignas(64) Counter {
    std::atomic<long> value{0};
    long other = 0;  // the other side's counter as last seen, never ahead of it
  };

  int width_;
  long capacity_;
  std::vector<long> numbers_;  // shape (capacity)
  std::vector<double> rows_;   // shape (capacity x width)
  Counter put_;
  Counter taken_;
};

}  // namespace vehicle
