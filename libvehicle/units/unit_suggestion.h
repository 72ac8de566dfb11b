#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "libvehicle/units/unit_expression.h"

namespace vehicle {

/// The unit that was probably meant by one that readUnit() does not take, e.g. "km/h" for "km/hr" or "kmh", "kN/m" for
/// "KN/m" or "kM/m", "MN*m^-1" for "MN m^-1", "deg" for "grad", "m/s^2" for "m/s2"; nothing where none is near.
/// @param fits  whether a unit is of the kind expected: no other one is suggested
[[nodiscard]] std::optional<std::string> suggestUnit(std::string_view text,
                                                     const std::function<bool(const BaseUnits&)>& fits);

/// What a unit that this program does not read is in one that it does, e.g. "1 mph = 1.609344 km/h"; "" for none known
/// of the kind expected.
[[nodiscard]] std::string conversionOf(std::string_view text, const std::function<bool(const BaseUnits&)>& fits);

}  // namespace vehicle
