#pragma once

#include <cstdint>

namespace vehicle {

// Random numbers without a state: each is a function of its seed and its number, so any process may ask for any of them
// in any order and all get the same.

/// Mixes 64 bits so that every one of the input changes about half of the output.
/// Source: D. Stafford's variant 13 of the MurmurHash3 finaliser, as used by SplitMix64 (Steele, Lea, Flood 2014).
[[nodiscard]] constexpr std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// The number `index` of stream `stream` under `seed`.
[[nodiscard]] constexpr std::uint64_t countedRandom(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
  return mixed(mixed(mixed(seed) ^ stream) ^ index);
}

/// 64 bits as a number 0 <= u < 1, a multiple of 2^-53.
[[nodiscard]] constexpr double unitInterval(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

}  // namespace vehicle
