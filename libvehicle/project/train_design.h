#pragma once

#include <string>

#include "libvehicle/definition/train.h"

namespace vehicle {

/// The train of a design: the train's file with the numbers of the design in its vehicles and couplings. Equal vehicles
/// that follow each other stay together; each group's file is called NAME-UNIT.xml after its leading one.
/// @param train     as its file says it, vehicles read
/// @param base      assembled(train)
/// @param design    base with other numbers
/// @param name      of the new train's file, without ending
/// @throws std::invalid_argument  the design has a number that a train's file cannot give (a coupling's x)
[[nodiscard]] Train trainOf(const Train& train, const Vehicle& base, const Vehicle& design, const std::string& name);

}  // namespace vehicle
