#pragma once

#include "libvehicle/definition/topology.h"

namespace vehicle {

/// The second half of topologyOf(). Private to this room.
/// @param vehicle  whose references lead somewhere; nothing else is asked of it
[[nodiscard]] Topology buildTopology(const Vehicle& vehicle);

}  // namespace vehicle
