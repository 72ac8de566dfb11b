#pragma once

#include <array>
#include <memory>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/flat/flat_model.h"
#include "libvehicle/model/compiled_model.h"
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
/// rail; front and rear may differ in everything. The printed variants also need the paper's symmetry and no static
/// loads at heights.
[[nodiscard]] ProblemList flatUnsupported(const Topology& topology, FlatVariant variant);

/// The paper's equations for one vehicle. States, channels and columns are in the vehicle's own order, as in every
/// form; inside, the equations count parts from the front. Immutable: one object serves any number of threads.
class FlatForm : public System {
 public:
  [[nodiscard]] virtual FlatVariant variant() const = 0;
  [[nodiscard]] virtual const FlatParameters& parameters() const = 0;

  /// The right-hand side in inner order, for steppers that take it by type; nothing for the printed variants.
  /// It gives the bits of derivative(): both call the same equations.
  [[nodiscard]] virtual const FlatRhs* rhs() const = 0;

  /// Entry i of the inner state (zk, phi, z1, z2, zk', phi', z1', z2') is entry stateOrder()[i] of x. The identity
  /// where the file names carbody, front and rear bogie in this order.
  [[nodiscard]] virtual const std::array<int, 8>& stateOrder() const = 0;

  /// Inner wheel i (0 leads) is channel wheelOrder()[i] of the input: eta_i = u[wheelOrder()[i]], its rate
  /// u[4 + wheelOrder()[i]].
  [[nodiscard]] virtual const std::array<int, 4>& wheelOrder() const = 0;
};

/// @throws InvalidInput with flatUnsupported()
[[nodiscard]] std::unique_ptr<FlatForm> buildFlatForm(const CompiledModel& model,
                                                      FlatVariant variant = FlatVariant::kConsistent);

}  // namespace vehicle
