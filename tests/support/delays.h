#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <thread>

#include "libvehicle/threads/waiting.h"

namespace vehicle::test {

/// A number that depends on all of its arguments and on nothing else (splitmix64).
inline std::uint64_t scrambled(std::uint64_t a, std::uint64_t b = 0, std::uint64_t c = 0) {
  std::uint64_t z = a * 0x9e3779b97f4a7c15u + b * 0xd1b54a32d192ed03u + c * 0x8cb92ba72f3d8dd7u + 0x2545f4914f6cdd1du;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// Delays for TeamPolicy::injectDelay: most exchanges none, others a few pauses, a yield or a sleep, drawn from seed,
/// thread and epoch, so that every seed is another interleaving.
inline std::function<void(int, long)> randomDelays(std::uint64_t seed) {
  return [seed](int thread, long epoch) {
    const std::uint64_t drawn = scrambled(seed, static_cast<std::uint64_t>(thread), static_cast<std::uint64_t>(epoch));
    const std::uint64_t kind = drawn % 32;
    if (kind < 6) {
      for (std::uint64_t i = 0; i < (drawn >> 8) % 200; ++i) pauseCore();
    } else if (kind < 9) {
      std::this_thread::yield();
    } else if (kind == 9 && (drawn >> 16) % 8 == 0) {
      std::this_thread::sleep_for(std::chrono::microseconds((drawn >> 8) % 50));
    }
  };
}

}  // namespace vehicle::test
