#pragma once

#include <string>

namespace vehicle::bench {

/// The last columns of every file of results: what made the figures.
inline constexpr const char* kBuiltByColumns = "compiler,flags,commit";

/// Their values in this build, e.g. "g++ 12.2.0,-O3 -g1 -ffp-contract=off,1a2b3c4"; "-dirty" after the commit where the
/// tree was modified.
[[nodiscard]] std::string builtBy();

/// Ends the program, before it measures, where results would be kept that nobody could measure again: those of a
/// modified tree or of none.
/// @param results  where they are to go; empty: nowhere
void requireKnownCommit(const std::string& results);

}  // namespace vehicle::bench
