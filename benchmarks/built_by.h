#pragma once

#include <string>

namespace vehicle::bench {

/// The last columns of every file of results: what made the figures.
inline constexpr const char* kBuiltByColumns = "compiler,flags,commit";

/// Their values in this build, e.g. "g++ 12.2.0,-O3 -g1 -ffp-contract=off,1a2b3c4".
[[nodiscard]] std::string builtBy();

}  // namespace vehicle::bench
