#pragma once

#include <cstdint>

namespace vehicle {

/// A shuffle of 0 .. n-1 that is computed, not stored: where each number goes follows from the key alone, in constant
/// time and memory, so that 10^9 designs can be dealt out without a list of them.
///
/// A Feistel network permutes the numbers of 2k bits, the smallest such range that holds n; a result beyond n is
/// permuted again until it lies within ("cycle walking", less than 4 times on average).
/// Source: J. Black, P. Rogaway, Ciphers with Arbitrary Finite Domains, CT-RSA 2002.
class KeyedPermutation {
 public:
  /// @param size  n, >= 1 and <= 2^62
  KeyedPermutation(std::uint64_t size, std::uint64_t key);

  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// @param index  < size()
  [[nodiscard]] std::uint64_t at(std::uint64_t index) const;

 private:
  std::uint64_t size_;
  std::uint64_t key_;
  unsigned half_bits_ = 0;
  std::uint64_t half_mask_ = 0;
};

}  // namespace vehicle
