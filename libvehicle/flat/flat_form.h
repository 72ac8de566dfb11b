#pragma once

#include <memory>

#include "libvehicle/definition/vehicle.h"
#include "libvehicle/system/system.h"

namespace vehicle {

/// Which reading of the source paper's equations; docs/theory/errata.md tells what differs and why.
enum class FlatVariant {
  kConsistent,  // "flat": equations (2)-(5) as they must read, identical to (7) with the right symbols
  kPrinted7,    // "flat-7-printed": (7) with the printed mapping b1 = bk, b2 = bb
  kLiteral,     // "flat-literal": (2)-(5) to the letter
  kLiteralMb,   // "flat-literal-mb": (2)-(5) to the letter, only the inertia of (4) repaired to mb z1''
};

/// Why the flat form cannot represent this vehicle, one problem an element; empty if it can. It represents one
/// carbody (z, pitch) on two bogies (z) by one suspension each, each bogie on two wheelsets that follow the
/// rail; front and rear may differ in everything. The printed variants also need the paper's symmetry.
[[nodiscard]] ProblemList flatMisfits(const Vehicle& vehicle, FlatVariant variant);

/// @throws InvalidInput with flatMisfits()
[[nodiscard]] std::unique_ptr<System> buildFlatForm(const Vehicle& vehicle, double gravity,
                                                    FlatVariant variant = FlatVariant::kConsistent);

}  // namespace vehicle
