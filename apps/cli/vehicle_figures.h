#pragma once

#include <vector>

#include "apps/cli/document.h"
#include "libvehicle/model/compiled_model.h"

namespace vehicle::cli {

// The figures that an engineer checks first.

/// (wheel load - mean) / mean of each wheelset [-], the mean being that of its vehicle; empty where none differs by
/// more than 0.05 %.
[[nodiscard]] std::vector<double> loadDeviations(const Topology& topology, const Rest& rest);

/// Total weight; and of a vehicle whose halves load the rail differently what each does.
[[nodiscard]] std::vector<Fact> loadFacts(const CompiledModel& model);

/// Undamped frequency and damping ratio of the modes in which the carbody takes most part: bounce and pitch. None for a
/// train, and for a vehicle without one body on top.
[[nodiscard]] Table carbodyTable(const CompiledModel& model);

}  // namespace vehicle::cli
