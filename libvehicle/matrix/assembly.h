#pragma once

#include "libvehicle/definition/topology.h"
#include "libvehicle/matrix/matrix_form.h"
#include "libvehicle/statics/rest.h"

namespace vehicle {

/// Elongation of a suspension: row . q - eta_channel (no such term where channel < 0).
struct Elongation {
  Eigen::RowVectorXd row;  // [-, m] (N)
  int channel = -1;        // wheelset that follows the rail
};

[[nodiscard]] Elongation elongationOf(const TopologySuspension& suspension, const Topology& topology);

/// The matrices of a topology about its rest position (docs/theory/vertical.md).
/// @param rest  static-load terms of heights and linearised contacts
[[nodiscard]] SecondOrder assemble(const Topology& topology, const Rest& rest);

}  // namespace vehicle
