#pragma once

#include <array>

#include "libvehicle/flat/flat_model.h"

namespace vehicle {

/// Equation (7) of the source paper: the symmetric vehicle as first-order system x' = A x + B u.
///
/// State x = (z1, z1', z2, z2', zk, zk', phi, phi'), input u = (eta1..eta4, eta1'..eta4'), wheels counted from
/// the leading one. Written from the printed matrix and not from (2)-(5): it is their witness.
struct Equation7 {
  std::array<std::array<double, 8>, 8> A{};  // [1/s and mixed]
  std::array<std::array<double, 8>, 8> B{};
};

/// The letters of (7). The text below it says b1 = bk, b2 = bb; consistent is b1 = bb, b2 = bk (errata row 8),
/// because b1 multiplies eta' - z' of a wheel.
struct Equation7Letters {
  double mk = 0.0, j2 = 0.0, mb = 0.0;  // [kg, kg m^2, kg] carbody, its pitch inertia, bogie
  double a2 = 0.0;                      // [m] half the distance of the pivots
  double c1 = 0.0, b1 = 0.0;            // [N/m, N s/m] between wheel and bogie, per axle
  double c2 = 0.0, b2 = 0.0;            // [N/m, N s/m] between bogie and carbody, per bogie
};

enum class Mapping {
  kConsistent,  // b1 = bb, b2 = bk
  kPrinted,     // b1 = bk, b2 = bb
};

/// The letters of (7) for a symmetric vehicle; of an asymmetric one the front's are taken.
[[nodiscard]] Equation7Letters lettersOf(const FlatParameters& parameters, Mapping mapping);

[[nodiscard]] Equation7 equation7(const Equation7Letters& letters);

}  // namespace vehicle
