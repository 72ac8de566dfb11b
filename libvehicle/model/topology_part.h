#pragma once

#include <vector>

#include "libvehicle/model/topology.h"

namespace vehicle {

/// What of a topology holds together, cut out of it. Coordinates are counted anew; points and cut suspensions are left
/// out.
struct TopologyPart {
  Topology topology;
  std::vector<int> bodies;       // index in the whole of each of its bodies, ascending
  std::vector<int> wheelsets;    // of each of its wheelsets
  std::vector<int> suspensions;  // of each of its suspensions
};

/// Takes a topology apart where suspensions are cut; parts are in the order of their first bodies.
/// @param cut  (suspensions) not 0: what this one joins is held together by others or not at all
[[nodiscard]] std::vector<TopologyPart> partsOf(const Topology& topology, const std::vector<char>& cut);

}  // namespace vehicle
