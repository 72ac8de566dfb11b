#pragma once

#include <vector>

#include "libvehicle/linear/modes.h"
#include "libvehicle/linear/undamped.h"
#include "libvehicle/report/document/document.h"
#include "libvehicle/units/channel.h"

namespace vehicle::report {

/// Eigenvalues, frequencies and damping ratios, one line a mode.
[[nodiscard]] Table eigenvalueTable(const std::vector<Mode>& modes, const std::vector<UndampedMode>& undamped);

/// Shapes, the largest coordinate of each being 1: for people a matrix of amplitudes and phases, coordinates as rows;
/// for other programs one line a mode and coordinate that takes part.
/// @param states  of the system that has the modes: coordinates, then their rates
[[nodiscard]] Table shapeTable(const std::vector<Mode>& modes, const std::vector<Channel>& states, Format format);

}  // namespace vehicle::report
