#include "libvehicle/units/unit_expression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace vehicle {

namespace {

/// Prefixes that a symbol takes. Nobody means megaseconds, megametres or gigaradians: "Ms", "Mm" and "Grad" are
/// mistyped, and to take them would make 5 mm of corrugation 5000 km.
enum class Prefixes {
  kNone,
  kSmall,   // n u m c d
  kToKilo,  // and k
  kAll,
};

struct Symbol {
  std::string_view text;
  Prefixes prefixes;
  Unit unit;
};

constexpr BaseUnits kForce = {1.0, 1.0, -2.0, 0.0};
constexpr std::array kSymbols = {
    Symbol{"m", Prefixes::kToKilo, {{0.0, 1.0, 0.0, 0.0}}},
    Symbol{"g", Prefixes::kAll, {{1.0, 0.0, 0.0, 0.0}, -3.0}},
    Symbol{"t", Prefixes::kAll, {{1.0, 0.0, 0.0, 0.0}, 3.0}},
    Symbol{"N", Prefixes::kAll, {kForce}},
    Symbol{"s", Prefixes::kSmall, {{0.0, 0.0, 1.0, 0.0}}},
    Symbol{"rad", Prefixes::kSmall, {{0.0, 0.0, 0.0, 1.0}}},
    Symbol{"Hz", Prefixes::kAll, {{0.0, 0.0, -1.0, 0.0}}},
    Symbol{"tf", Prefixes::kAll, {kForce, -2.0, 0.0, 1.0}},
    Symbol{"deg", Prefixes::kNone, {{0.0, 0.0, 0.0, 1.0}, 0.0, 0.0, 0.0, 1.0}},
    Symbol{"min", Prefixes::kNone, {{0.0, 0.0, 1.0, 0.0}, 1.0, 1.0}},
    Symbol{"h", Prefixes::kNone, {{0.0, 0.0, 1.0, 0.0}, 2.0, 2.0}},
    Symbol{"%", Prefixes::kNone, {{}, -2.0}},
};

constexpr std::array<std::pair<std::string_view, double>, 10> kPrefixes = {
    {{"n", -9.0}, {"u", -6.0}, {"\u00b5", -6.0}, {"\u03bc", -6.0}, {"m", -3.0}, {"c", -2.0}, {"d", -1.0}, {"k", 3.0},
     {"M", 6.0}, {"G", 9.0}}};

std::optional<Unit> lookUp(std::string_view text) {
  for (const Symbol& symbol : kSymbols) {
    if (symbol.text == text) return symbol.unit;
  }
  for (const Symbol& symbol : kSymbols) {
    if (symbol.prefixes == Prefixes::kNone || !text.ends_with(symbol.text)) continue;
    const double most = symbol.prefixes == Prefixes::kSmall ? 0.0 : symbol.prefixes == Prefixes::kToKilo ? 3.0 : 9.0;
    for (const auto& [prefix, power] : kPrefixes) {
      if (power > most) continue;
      if (text.size() != prefix.size() + symbol.text.size() || !text.starts_with(prefix)) continue;
      Unit unit = symbol.unit;
      unit.ten += power;
      return unit;
    }
  }
  return std::nullopt;
}

// A message is one line to be read: of a runaway text the head is enough.
std::string quoted(std::string_view text) {
  constexpr std::size_t kShown = 32;
  return '"' + std::string(text.substr(0, kShown)) + (text.size() > kShown ? "...\"" : "\"");
}

// Recursive descent; the first error ends it.
class Parser {
 public:
  explicit Parser(std::string_view text) : whole_(text), rest_(text) {}

  UnitReading read() {
    UnitReading reading;
    Unit unit;
    if (product(unit, 0) && (rest_.empty() || fail()) && (isMeasured(unit) || fail())) {
      reading.unit = unit;
    } else {
      reading.message = message_;
      reading.hint = hint_;
    }
    return reading;
  }

 private:
  static constexpr int kDepth = 8;  // of parentheses: what a unit may need, and what a stack can bear

  // Nested powers ((h^9)^9) run away from anything that was ever measured, and so would the digits of toSi().
  static bool isMeasured(const Unit& unit) {
    constexpr double kLargest = 100.0;
    return std::max({std::abs(unit.ten), std::abs(unit.six), std::abs(unit.technical), std::abs(unit.degree)}) <=
           kLargest;
  }

  // Always false, so that callers may `return fail(...)`.
  bool fail(std::string message = "", std::string hint = "") {
    message_ = message.empty() ? "has the malformed unit " + quoted(whole_) : std::move(message);
    hint_ = std::move(hint);
    return false;
  }

  bool take(std::string_view token) {
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }

  bool skipSpaces() {
    const std::size_t before = rest_.size();
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t')) rest_.remove_prefix(1);
    return rest_.size() != before;
  }

  bool product(Unit& unit, int depth) {
    double sign = 1.0;
    for (;;) {
      skipSpaces();
      if (!factor(unit, sign, depth)) return false;
      const bool space = skipSpaces();
      if (take("*") || take("\u00b7") || take("\u22c5")) {
        sign = 1.0;
      } else if (take("/")) {
        sign = -1.0;
      } else if (space && !rest_.empty() && rest_.front() != ')') {
        return fail("", "join factors with \"*\", as in \"t*m^2\"");
      } else {
        return true;
      }
    }
  }

  bool factor(Unit& unit, double sign, int depth) {
    Unit inner;
    if (take("(")) {
      if (depth >= kDepth || !product(inner, depth + 1)) return message_.empty() ? fail() : false;
      if (!take(")")) return fail();
    } else if (!symbol(inner)) {
      return false;
    }
    double power = 1.0;
    if (!readPower(power)) return false;
    unit.multiply(inner, sign * power);
    return true;
  }

  bool symbol(Unit& unit) {
    const std::string_view start = rest_;
    while (!rest_.empty() && isSymbolByte()) rest_.remove_prefix(1);
    const std::string_view text = start.substr(0, start.size() - rest_.size());
    if (text.empty()) return fail();
    const std::optional<Unit> found = lookUp(text);
    if (!found) return fail("has the unknown unit " + quoted(text));
    if (!rest_.empty() && rest_.front() >= '0' && rest_.front() <= '9') {
      return fail("", "a power is written with \"^\", as in \"m^2\"");
    }
    unit = *found;
    return true;
  }

  [[nodiscard]] bool isSymbolByte() const {
    for (const std::string_view sign : {"\u00b7", "\u22c5", "\u00b2", "\u00b3"}) {
      if (rest_.starts_with(sign)) return false;
    }
    const auto c = static_cast<unsigned char>(rest_.front());
    return c >= 0x80 || c == '%' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  }

  bool readPower(double& power) {
    constexpr double kLargest = 9.0;
    if (take("\u00b2")) {
      power = 2.0;
    } else if (take("\u00b3")) {
      power = 3.0;
    } else if (take("^")) {
      const std::optional<Decimal> number = cutDecimal(rest_);
      if (!number) return fail();
      power = number->nearest();
    }
    return std::abs(power) <= kLargest || fail();
  }

  std::string_view whole_;
  std::string_view rest_;
  std::string message_;
  std::string hint_;
};

}  // namespace

void Unit::multiply(const Unit& other, double power) {
  base.kg += power * other.base.kg;
  base.m += power * other.base.m;
  base.s += power * other.base.s;
  base.rad += power * other.base.rad;
  ten += power * other.ten;
  six += power * other.six;
  technical += power * other.technical;
  degree += power * other.degree;
}

double Unit::toSi(Decimal number) const {
  // Whole powers multiply the digits or gather in one divisor; what is left of broken ones (mm^1.5) has to
  // be rounded.
  double divisor = 1.0;
  double broken = 1.0;
  const auto apply = [&](unsigned long factor, double power) {
    const double whole = std::trunc(power);
    for (double i = 0.0; i < whole; ++i) number.multiply(factor);
    for (double i = 0.0; i > whole; --i) divisor *= static_cast<double>(factor);
    broken *= std::pow(static_cast<double>(factor), power - whole);
  };
  apply(6, six);
  apply(980665, technical);
  number.exponent += static_cast<long>(std::trunc(ten));
  broken *= std::pow(10.0, ten - std::trunc(ten));
  // 3 m/min is 3/60, not 0.3/6: decimals join the divisor, as long as that stays a whole number of a double.
  constexpr double kWhole = 0x1p53;
  while (divisor > 1.0 && number.exponent < 0 && divisor * 10.0 <= kWhole) {
    divisor *= 10.0;
    ++number.exponent;
  }
  double value = number.nearest() / divisor;
  if (broken != 1.0) value *= broken;
  if (degree != 0.0) {
    // In long double, where there is one: 180 deg is then the double nearest to pi.
    value = static_cast<double>(value * std::pow(std::numbers::pi_v<long double> / 180.0L,
                                                 static_cast<long double>(degree)));
  }
  return value;
}

UnitReading readUnit(std::string_view text) {
  if (text.empty()) return {Unit{}, "", ""};
  return Parser(text).read();
}

}  // namespace vehicle
