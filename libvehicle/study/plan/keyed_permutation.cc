#include "libvehicle/study/plan/keyed_permutation.h"

#include <stdexcept>
#include <utility>

#include "libvehicle/study/plan/counted_random.h"

namespace vehicle {

namespace {

// Four rounds hide the key from an attacker; two more cost little and even out the very small ranges.
constexpr std::uint64_t kRounds = 6;

}  // namespace

KeyedPermutation::KeyedPermutation(std::uint64_t size, std::uint64_t key) : size_(size), key_(key) {
  if (size < 1 || size > (std::uint64_t{1} << 62)) {
    throw std::invalid_argument("KeyedPermutation: size must be 1 .. 2^62");
  }
  while ((std::uint64_t{1} << (2 * half_bits_)) < size) ++half_bits_;
  half_mask_ = (std::uint64_t{1} << half_bits_) - 1;
}

std::uint64_t KeyedPermutation::at(std::uint64_t index) const {
  if (index >= size_) throw std::invalid_argument("KeyedPermutation: index beyond the size");
  do {
    std::uint64_t left = index >> half_bits_;
    std::uint64_t right = index & half_mask_;
    for (std::uint64_t round = 0; round < kRounds; ++round) {
      left ^= countedRandom(key_, round, right) & half_mask_;
      std::swap(left, right);
    }
    index = (left << half_bits_) | right;
  } while (index >= size_);
  return index;
}

}  // namespace vehicle
