#include "libvehicle/threads/mailbox.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <string>

namespace vehicle {

Mailbox::Mailbox(int width, int capacity) : width_(width), capacity_(capacity) {
  if (width < 0) throw std::invalid_argument("mailbox: width = " + std::to_string(width) + ", must be >= 0");
  if (capacity < 1) throw std::invalid_argument("mailbox: capacity = " + std::to_string(capacity) + ", must be >= 1");
  numbers_.resize(static_cast<std::size_t>(capacity));
  rows_.resize(static_cast<std::size_t>(capacity) * static_cast<std::size_t>(width));
}

bool Mailbox::put(long number, std::span<const double> row) {
  if (row.size() != static_cast<std::size_t>(width_)) {
    throw std::invalid_argument("mailbox: a row of " + std::to_string(row.size()) + " values, must have " +
                                std::to_string(width_));
  }
  const long at = put_.value.load(std::memory_order_relaxed);
  if (at - put_.other == capacity_) {
    put_.other = taken_.value.load(std::memory_order_acquire);
    if (at - put_.other == capacity_) return false;
  }
  const auto place = static_cast<std::size_t>(at % capacity_);
  numbers_[place] = number;
  std::copy(row.begin(), row.end(), rows_.begin() + static_cast<std::ptrdiff_t>(place * row.size()));
  put_.value.store(at + 1, std::memory_order_release);
  return true;
}

const double* Mailbox::front(long& number) {
  const long at = taken_.value.load(std::memory_order_relaxed);
  if (at == taken_.other) {
    taken_.other = put_.value.load(std::memory_order_acquire);
    if (at == taken_.other) return nullptr;
  }
  const auto place = static_cast<std::size_t>(at % capacity_);
  number = numbers_[place];
  return rows_.data() + place * static_cast<std::size_t>(width_);
}

void Mailbox::pop() {
  const long at = taken_.value.load(std::memory_order_relaxed);
  assert(at < taken_.other);  // front() gave a row that is still there
  taken_.value.store(at + 1, std::memory_order_release);
}

}  // namespace vehicle
