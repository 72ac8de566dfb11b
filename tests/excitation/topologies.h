#pragma once

#include "libvehicle/model/topology.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {

inline Topology paperTopology() { return topologyOf(paperVehicle()); }

/// That many wheelsets, 6.5 m from one to the next.
inline Topology wheelsets(int count) {
  Topology made;
  for (int j = 0; j < count; ++j) {
    TopologyWheelset wheelset;
    wheelset.x = -6.5 * j;
    made.wheelsets.push_back(wheelset);
  }
  return made;
}

}  // namespace vehicle::test
