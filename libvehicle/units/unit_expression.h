#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "libvehicle/units/decimal.h"

namespace vehicle {

/// Exponents of the base units. Angle counts, so that rad/s is no Hz. Halves occur (N/m^1.5).
struct BaseUnits {
  double kg = 0.0;
  double m = 0.0;
  double s = 0.0;
  double rad = 0.0;
  bool operator==(const BaseUnits&) const = default;
};

/// A unit: its base units, and its scale to SI as powers of whole numbers, so that nothing is rounded before
/// the number is known:  scale = 10^ten 6^six 980665^technical (pi/180)^degree.
struct Unit {
  BaseUnits base;
  double ten = 0.0;
  double six = 0.0;        // min = 6 * 10 s, h = 6^2 * 10^2 s
  double technical = 0.0;  // tf = 980665 / 10^2 N
  double degree = 0.0;

  /// This unit times other^power.
  void multiply(const Unit& other, double power);

  /// The number in SI: rounded once where the scale is a whole number or its inverse and the number has at
  /// most 15 digits, so that 9 mm is 9/1000 and 110 km/h is 110 * 1000 / 3600. Overflow gives inf.
  [[nodiscard]] double toSi(Decimal number) const;
};

/// A unit, read; or why not, in the words of ParsedQuantity.
struct UnitReading {
  std::optional<Unit> unit;
  std::string message;  // e.g. `has the unknown unit "kM"`
  std::string hint;     // e.g. `join factors with "*"`; may be empty
};

/// Reads "kN*s/m", "tf*m*s^2", "GN/m^1.5", "N/(m/s)".
///
/// Symbols: m g t N s rad Hz tf with the prefixes n u (or the micro sign) m c d k M G (m up to k, s and rad up to d),
/// and deg min h % without. Products `*` or the middle dot, quotients `/` from left to right, parentheses, powers `^2`,
/// `^-1`, `^1.5` or superscript 2 and 3 up to 9. "" is the unit of a plain number.
[[nodiscard]] UnitReading readUnit(std::string_view text);

}  // namespace vehicle
