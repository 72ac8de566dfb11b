#pragma once

#include <vector>

#include "libvehicle/law/suspension_law.h"
#include "libvehicle/model/topology.h"

namespace vehicle {

/// The law by which a suspension answers its elongation, both sides together.
[[nodiscard]] SuspensionLawPtr lawOf(const TopologySuspension& suspension);

/// Of all suspensions, in their order.
[[nodiscard]] std::vector<SuspensionLawPtr> lawsOf(const Topology& topology);

}  // namespace vehicle
