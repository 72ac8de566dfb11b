#pragma once

#include <string>
#include <vector>

#include "libvehicle/partition/scheme.h"

namespace vehicle {

/// Most threads a run may ask for.
inline constexpr int kMostThreads = 256;

/// The schemes by which threads can share the work of a method, serial first.
///     rk4: serial, stages, halo, pipeline     exact: serial, rows     rk4_split, exact_split: serial, split
///     others: serial
[[nodiscard]] std::vector<Scheme> schemesOf(const std::string& method);

/// Why this method on that form cannot run on so many threads by that scheme, in one sentence with its remedy; empty
/// if it can, as far as names tell: a vehicle may still have fewer equations than threads.
/// @param threads  0: chosen; 1..kMostThreads   @param scheme  schemeNames(), or empty: chosen
/// @throws std::invalid_argument for a number or a name that does not exist, naming the nearest one
[[nodiscard]] std::string threadsMisfit(const std::string& form, const std::string& method, int threads,
                                        const std::string& scheme);

/// Whether several threads could share a run of that form by that method at all.
[[nodiscard]] bool canBeShared(const std::string& form, const std::string& method);

/// Why nobody would read that map, with the remedy; empty if somebody does, or may.
/// @param threads  0: left open   @param scheme  schemeNames(), or empty: left open   @param map  equationMapNames()
[[nodiscard]] std::string mapMisfit(const std::string& form, const std::string& method, int threads,
                                    const std::string& scheme, const std::string& map);

}  // namespace vehicle
