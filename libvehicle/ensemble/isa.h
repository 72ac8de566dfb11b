#pragma once

#include <string_view>
#include <vector>

namespace vehicle {

/// Instruction sets that the ensemble's kernels are compiled for, all in one binary.
enum class Isa {
  kBaseline,  // "baseline": x86-64 with SSE2, 2 designs at once, multiplies and adds rounded apart
  kV3,        // "v3": x86-64-v3, AVX2 and FMA, 4 designs at once
  kV4,        // "v4": x86-64-v4, AVX-512, 8 designs at once
};

/// Whether this machine has it.
[[nodiscard]] bool supports(Isa isa);
/// The widest one that this machine has.
[[nodiscard]] Isa bestIsa();
/// All that this machine has, narrowest first.
[[nodiscard]] std::vector<Isa> supportedIsas();
[[nodiscard]] std::string_view nameOf(Isa isa);
/// Designs that one SIMD register holds.
[[nodiscard]] int lanesOf(Isa isa);

}  // namespace vehicle
