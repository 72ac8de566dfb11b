#pragma once

#include <cstddef>
#include <string>

#include "libvehicle/definition/train.h"

namespace vehicle {

// Parts of a train, for its checks and for its assembly. Private to this room.

/// Whether the vehicle's file has been read.
[[nodiscard]] bool isRead(const TrainVehicle& each);

/// What its units are called, before the number: as the train says, else as the vehicle calls itself.
[[nodiscard]] const std::string& unitName(const TrainVehicle& each);
/// "coach.xml" in quotes, as messages call it; without a file its unitName().
[[nodiscard]] std::string quotedName(const TrainVehicle& each);

/// Place of a body in its vehicle, its group counted in [m].
[[nodiscard]] double bodyX(const Vehicle& vehicle, const Body& body);

/// The coupling behind unit `gap` (0 leads), or null.
[[nodiscard]] const Coupling* couplingAt(const Train& train, std::size_t gap);

/// From origin to origin of two neighbours [m].
[[nodiscard]] double shiftBetween(const TrainVehicle& ahead, const TrainVehicle& behind);

}  // namespace vehicle
