#pragma once

#include <string>
#include <vector>

#include "libvehicle/partition/scheme.h"

namespace vehicle {

/// Most threads a run may ask for.
inline constexpr int kMostThreads = 256;

/// The schemes by which threads can share the work of a method, serial first.
[[nodiscard]] std::vector<Scheme> schemesOf(const std::string& method);

/// Why this method on that form cannot run on so many threads by that scheme, in one sentence with its remedy; empty
/// if it can, as far as names show: a vehicle may still have fewer equations than threads.
/// @param sharing  0 .. kMostThreads threads
/// @throws std::invalid_argument for another number
[[nodiscard]] std::string threadsUnsupported(const std::string& form, const std::string& method,
                                             const Sharing& sharing);

/// Whether several threads could share a run of that form by that method at all.
[[nodiscard]] bool canBeShared(const std::string& form, const std::string& method);

/// Why nobody would read the map, with the remedy; empty if somebody does, or may.
[[nodiscard]] std::string mapUnsupported(const std::string& form, const std::string& method, const Sharing& sharing);

}  // namespace vehicle
