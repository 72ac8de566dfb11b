#include "libvehicle/units/quantity.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "libvehicle/units/number_separators.h"
#include "libvehicle/units/unit_expression.h"
#include "libvehicle/units/unit_suggestion.h"

namespace vehicle {

namespace {

struct Kind {
  Dimension dimension;
  DimensionInfo info;
  BaseUnits base;
  std::array<std::string_view, 4> customary;  // in order of preference, the SI unit among them
};

// In the order of the enumerators.
constexpr std::array<Kind, 17> kKinds = {{
    {Dimension::kNumber, {"plain number", "", "3"}, {}, {""}},
    {Dimension::kLength, {"length", "m", "3.725 m"}, {0, 1, 0, 0}, {"m", "mm"}},
    {Dimension::kTime, {"time", "s", "5 ms"}, {0, 0, 1, 0}, {"s", "ms"}},
    {Dimension::kSpeed, {"speed", "m/s", "72 km/h"}, {0, 1, -1, 0}, {"m/s", "km/h", "mm/s"}},
    {Dimension::kAcceleration, {"acceleration", "m/s^2", "9.81 m/s^2"}, {0, 1, -2, 0}, {"m/s^2"}},
    {Dimension::kMass, {"mass", "kg", "57 t"}, {1, 0, 0, 0}, {"kg", "t"}},
    {Dimension::kInertia, {"moment of inertia", "kg*m^2", "70 t*m^2"}, {1, 2, 0, 0}, {"kg*m^2", "t*m^2"}},
    {Dimension::kForce, {"force", "N", "120 kN"}, {1, 1, -2, 0}, {"kN", "N"}},
    {Dimension::kStiffness, {"stiffness", "N/m", "3040 kN/m"}, {1, 0, -2, 0}, {"kN/m", "MN/m", "GN/m", "N/m"}},
    {Dimension::kDamping, {"damping", "N*s/m", "30 kN*s/m"}, {1, 0, -1, 0}, {"kN*s/m", "N*s/m"}},
    {Dimension::kRotationalStiffness, {"rotational stiffness", "N*m/rad", "940 kN*m/rad"}, {1, 2, -2, -1},
     {"kN*m/rad", "MN*m/rad", "N*m/rad"}},
    {Dimension::kRotationalDamping, {"rotational damping", "N*m*s/rad", "25 kN*m*s/rad"}, {1, 2, -1, -1},
     {"kN*m*s/rad", "N*m*s/rad"}},
    {Dimension::kHertzConstant, {"Hertz constant", "N/m^1.5", "93.7 GN/m^1.5"}, {1, -0.5, -2, 0},
     {"GN/m^1.5", "N/m^1.5"}},
    {Dimension::kAngle, {"angle", "rad", "1.2 mrad"}, {0, 0, 0, 1}, {"rad", "mrad", "deg"}},
    {Dimension::kAngularVelocity, {"angular velocity", "rad/s", "5.03 rad/s"}, {0, 0, -1, 1}, {"rad/s", "mrad/s"}},
    {Dimension::kFrequency, {"frequency", "Hz", "1.1 Hz"}, {0, 0, -1, 0}, {"Hz"}},
    {Dimension::kAngularAcceleration, {"angular acceleration", "rad/s^2", "0.5 rad/s^2"}, {0, 0, -2, 1}, {"rad/s^2"}},
}};

const Kind& kindOf(Dimension dimension) { return kKinds.at(static_cast<std::size_t>(dimension)); }

std::string withArticle(std::string_view name) {
  const bool vowel = std::string_view("aeiou").find(name.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + std::string(name);
}

std::string expectation(Dimension expected) {
  const DimensionInfo& info = describe(expected);
  return withArticle(info.name) + " is expected, e.g. \"" + std::string(info.example) + '"';
}

ParsedQuantity refuse(std::string message, std::string remedy) {
  return {std::nullopt, std::move(message), std::move(remedy)};
}

void trim(std::string_view& text) {
  constexpr std::string_view kSpaces = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(kSpaces), text.size()));
  text.remove_suffix(text.size() - (text.find_last_not_of(kSpaces) + 1));
}

// "nan", "-inf m", "Infinity": numbers to a C library, not to us.
bool saysNonFinite(std::string_view text) {
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  std::string word;
  for (const char c : text) {
    const char lower = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    if (lower < 'a' || lower > 'z') break;
    word += lower;
  }
  return word == "nan" || word == "inf" || word == "infinity";
}

// Engineers write the stiffness of a torsion spring per radian or leave the radian out.
bool accepts(const BaseUnits& expected, BaseUnits given) {
  if (expected.rad < 0.0 && given.rad == 0.0) given.rad = expected.rad;
  return given == expected;
}

// What was probably meant by a unit that is none, in the dimension expected.
std::string hintFor(std::string_view digits, std::string_view unit, const UnitReading& reading, Dimension expected) {
  const auto fits = [&](const BaseUnits& base) { return accepts(kindOf(expected).base, base); };
  const std::string conversion = conversionOf(unit, fits);
  if (!conversion.empty()) return "; " + conversion;
  if (const auto meant = suggestUnit(unit, fits)) {
    return "; did you mean \"" + std::string(digits) + (*meant == "%" ? "" : " ") + *meant + "\"?";
  }
  return reading.hint.empty() ? "" : "; " + reading.hint;
}

ParsedQuantity refuseDimension(const BaseUnits& given, std::string_view unit, Dimension expected) {
  if (unit.empty()) return refuse("has no unit", expectation(expected));
  for (const Kind& kind : kKinds) {
    if (kind.base == given) return refuse("is " + withArticle(kind.info.name), expectation(expected));
  }
  return refuse("has the unit \"" + std::string(unit) + '"', expectation(expected));
}

// `number` in a unit that is no power of ten away from SI: the fewest digits that read back to `si`, if 15 do.
std::optional<std::string> fewestDigits(double number, const Unit& unit, double si) {
  for (int digits = 1; digits <= 15; ++digits) {
    std::array<char, 64> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number,
                                            std::chars_format::scientific, digits - 1);
    std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
    const std::optional<Decimal> decimal = cutDecimal(text);
    if (decimal && unit.toSi(*decimal) == si) return decimal->text();
  }
  return std::nullopt;
}

}  // namespace

const DimensionInfo& describe(Dimension dimension) { return kindOf(dimension).info; }

ParsedQuantity parseQuantity(std::string_view text, Dimension expected) {
  trim(text);
  if (text.empty()) return refuse("is empty", expectation(expected));
  if (saysNonFinite(text)) return refuse("is not finite", expectation(expected));
  std::string_view rest = text;
  const std::optional<Decimal> number = cutDecimal(rest);
  if (!number) return refuse("is not a number", expectation(expected));
  if (std::optional<SeparatedNumber> separated = separatorsIn(text)) {
    return refuse(std::move(separated->message), std::move(separated->remedy));
  }
  if (!rest.empty() && (rest[0] == '.' || rest[0] == ',' || rest[0] == '+' || rest[0] == '-')) {
    return refuse("is not a number", expectation(expected));
  }
  const std::string_view digits = text.substr(0, text.size() - rest.size());
  trim(rest);
  const UnitReading reading = readUnit(rest);
  if (!reading.unit) return refuse(reading.message, expectation(expected) + hintFor(digits, rest, reading, expected));
  if (!accepts(kindOf(expected).base, reading.unit->base)) return refuseDimension(reading.unit->base, rest, expected);
  const double si = reading.unit->toSi(*number);
  if (!std::isfinite(si)) return refuse("is not finite", "a number holds up to 1.8e308 in SI units");
  if (!number->digits.empty() && std::abs(si) < std::numeric_limits<double>::min()) {
    return refuse("is too close to zero", "a number holds down to 2.3e-308 in SI units; write 0 for none");
  }
  return {si, "", ""};
}

std::string formatQuantity(double si, Dimension dimension) {
  if (!std::isfinite(si)) throw std::invalid_argument("formatQuantity: si must be finite");
  std::string shortest;
  for (const std::string_view symbol : kindOf(dimension).customary) {
    if (symbol.empty() && dimension != Dimension::kNumber) break;
    const Unit unit = *readUnit(symbol).unit;
    std::optional<std::string> number;
    if (unit.six == 0.0 && unit.degree == 0.0) {
      Decimal decimal = shortestDecimal(si);
      if (!decimal.digits.empty()) decimal.exponent -= static_cast<long>(unit.ten);
      number = decimal.text();
    } else {
      number = fewestDigits(si / unit.toSi({false, "1", 0}), unit, si);
    }
    if (!number) continue;
    const std::string text = symbol.empty() ? *number : *number + ' ' + std::string(symbol);
    if (shortest.empty() || text.size() < shortest.size()) shortest = text;
    if (symbol.empty() || si == 0.0) break;
  }
  return shortest;
}

}  // namespace vehicle
