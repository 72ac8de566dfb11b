#pragma once

#include <string>

#include "libvehicle/diagnostics/problem.h"

namespace vehicle {

/// Where a part of a definition was written. It is no part of the value: two parts that say the same in
/// different places are equal.
struct Origin : Place {
  bool operator==(const Origin&) const { return true; }
};

/// A quantity the file holds for formulations that this program does not build yet (y, roll_inertia, ...):
/// kept as written and written back unchanged.
struct ReservedQuantity {
  std::string attribute;  // e.g. "roll_inertia"
  std::string text;       // e.g. "56.8 t*m^2"
  bool operator==(const ReservedQuantity&) const = default;
};

}  // namespace vehicle
