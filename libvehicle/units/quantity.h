#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace vehicle {

/// Kinds of quantity that a file may hold. Angle is a kind of its own, so that "5 mm" is no phase.
enum class Dimension {
  kNumber,              // no unit
  kLength,              // m
  kTime,                // s
  kSpeed,               // m/s
  kAcceleration,        // m/s^2
  kMass,                // kg
  kInertia,             // kg*m^2
  kForce,               // N
  kStiffness,           // N/m
  kDamping,             // N*s/m
  kRotationalStiffness, // N*m/rad
  kRotationalDamping,   // N*m*s/rad
  kHertzConstant,       // N/m^1.5
  kAngle,               // rad
  kAngularVelocity,     // rad/s
  kFrequency,           // Hz
  kAngularAcceleration, // rad/s^2
};

/// What a dimension is called in a message ("stiffness"), its SI unit ("N/m") and an example ("30 kN/m").
struct DimensionInfo {
  std::string_view name;
  std::string_view siUnit;
  std::string_view example;
};
[[nodiscard]] const DimensionInfo& describe(Dimension dimension);

/// A number with a unit, read; or why not.
struct ParsedQuantity {
  std::optional<double> si;  // value in SI
  std::string message;       // when !si: e.g. `is a stiffness`, `has no unit`, `has the unknown unit "kM"`
  std::string remedy;        // when !si: e.g. `a damping is expected, e.g. "30 kN*s/m"`
};

/// Reads "430 kN/m", "70 tf*m*s^2", "1.2 mrad", "72 km/h" as a quantity of the dimension expected.
///
/// A unit is a product or quotient of symbols, each with a prefix and a power ("kN*s/m", "t*m^2",
/// "GN/m^1.5"). Prefixes are powers of ten that are multiplied or divided by, never multiplied by a rounded
/// fraction: 9 mm is 9/1000, the nearest double to 0.009. 1 tf = 9806.65 N. Spaces around the number are free.
/// A rotational stiffness or damping may leave the radian out ("940 kN*m"); nowhere else is an angle optional.
/// The grammar of units stands in unit_expression.h. The locale has no say: the decimal sign is a point.
/// Refused: no number, nan, inf, out of range of a double (also too close to zero), no unit, unknown unit,
/// other dimension, malformed unit.
[[nodiscard]] ParsedQuantity parseQuantity(std::string_view text, Dimension expected);

/// Text that parseQuantity() reads back to the same bits: in the customary unit of the railway where that
/// is exact ("3040 kN/m"), otherwise in SI with as many digits as are needed. The shortest text wins;
/// 0 is 0 of the customary unit.
/// @param si  finite, and not subnormal (parseQuantity() refuses those as too close to zero)
/// @throws std::invalid_argument if si is not finite
[[nodiscard]] std::string formatQuantity(double si, Dimension dimension);

}  // namespace vehicle
