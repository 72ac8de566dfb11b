#include "libvehicle/threads/exchange.h"

#include <stdexcept>
#include <string>

namespace vehicle {

Exchange::Exchange(const std::vector<int>& values_of_thread) {
  if (values_of_thread.empty()) throw std::invalid_argument("exchange: no thread");
  std::size_t bytes = 0;
  std::vector<std::size_t> offsets;
  for (std::size_t i = 0; i < values_of_thread.size(); ++i) {
    const int values = values_of_thread[i];
    if (values < 0) {
      throw std::invalid_argument("exchange: thread " + std::to_string(i) + " shows " + std::to_string(values) +
                                  " values, must be >= 0");
    }
    const std::size_t lines = (sizeof(double) * (static_cast<std::size_t>(values) + 1) + 63) / 64;
    owners_.push_back({.slot_bytes = 64 * lines, .values = values});
    offsets.push_back(bytes);
    bytes += (2 * 64 * lines + kApart - 1) / kApart * kApart;
  }
  memory_.reset(static_cast<std::byte*>(::operator new (bytes, std::align_val_t{kApart})));
  for (std::size_t i = 0; i < owners_.size(); ++i) {
    owners_[i].begin = memory_.get() + offsets[i];
    for (long parity = 0; parity < 2; ++parity) {
      std::byte* at = owners_[i].begin + static_cast<std::size_t>(parity) * owners_[i].slot_bytes;
      Line* line = new (at) Line;
      double* values = line->values();
      for (int k = 0; k < owners_[i].values; ++k) new (values + k) double(0.0);
    }
  }
}

}  // namespace vehicle
