#pragma once

#include <string>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/study.h"
#include "libvehicle/definition/suite.h"
#include "libvehicle/definition/train.h"
#include "libvehicle/definition/vehicle.h"

namespace vehicle {

/// The text of a file that reads back to an equal definition, every number to the same bits.
///
/// Attributes at their defaults are left out, equal elements that follow each other are aligned in columns.
/// A title or source is written with single spaces between its words, as the reader gives it.
/// @throws std::invalid_argument if a number is not finite, or if no order of the elements gives back the order
///         of the parts (parts of a group must follow each other within their kind)
/// A vehicle as a file gives it; a train that has been assembled is written as the Train it came from.
[[nodiscard]] std::string write(const Vehicle& vehicle);
[[nodiscard]] std::string write(const Train& train);
[[nodiscard]] std::string write(const Scenario& scenario);
[[nodiscard]] std::string write(const Suite& suite);
[[nodiscard]] std::string write(const Study& study);

}  // namespace vehicle
