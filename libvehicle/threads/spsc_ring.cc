#include "libvehicle/threads/spsc_ring.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace vehicle {
namespace {

void requireAtLeast(const char* name, long value, long least) {
  if (value >= least) return;
  throw std::invalid_argument(std::string("ring: ") + name + " = " + std::to_string(value) +
                              ", must be >= " + std::to_string(least));
}

}  // namespace

SpscRing::SpscRing(int width, long capacity, long batch)
    : width_(static_cast<std::size_t>(width)), capacity_(capacity), batch_(batch) {
  requireAtLeast("width", width, 0);
  requireAtLeast("capacity", capacity, 1);
  requireAtLeast("batch", batch, 1);
  numbers_.resize(static_cast<std::size_t>(capacity));
  rows_.resize(numbers_.size() * width_);
  put_.left = taken_.left = batch;
}

bool SpscRing::put(long number, std::span<const double> row) {
  if (row.size() != width_) {
    throw std::invalid_argument("ring: a row of " + std::to_string(row.size()) + " values, must have " +
                                std::to_string(width_));
  }
  if (!hasRoom()) return false;
  numbers_[put_.place] = number;
  std::ranges::copy(row, rows_.begin() + static_cast<std::ptrdiff_t>(put_.place * width_));
  if (advance(put_)) flush();
  return true;
}

}  // namespace vehicle
