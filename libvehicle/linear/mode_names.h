#pragma once

#include <vector>

#include "libvehicle/linear/modes.h"

namespace vehicle {

/// Gives every mode its name from the coordinates that take most part in it.
///
/// "<part> bounce | pitch | roll | yaw | sway | surge" where one part leads; "<part> + <part> bounce in phase | in
/// antiphase" where two share, signs "(+ - - +)" where more do. Parts share if they have at least half the
/// participation of the leading one in the same kind of motion. Real roots add ", aperiodic", lambda = 0 ", free";
/// names that still coincide are numbered from the second on: "carbody pitch (2)".
/// @param modes   in their final order, shape and participation set
/// @param states  2N channels, the first N name the coordinates
void nameModes(std::vector<Mode>& modes, const std::vector<Channel>& states);

}  // namespace vehicle
