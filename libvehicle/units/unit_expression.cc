#include "libvehicle/units/unit_expression.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <utility>

namespace vehicle {

namespace {

struct Symbol {
  std::string_view text;
  bool takes_prefix;
  Unit unit;
};

constexpr BaseUnits kForce = {1.0, 1.0, -2.0, 0.0};
constexpr std::array kSymbols = {
    Symbol{"m", true, {{0.0, 1.0, 0.0, 0.0}}},
    Symbol{"g", true, {{1.0, 0.0, 0.0, 0.0}, -3.0}},
    Symbol{"t", true, {{1.0, 0.0, 0.0, 0.0}, 3.0}},
    Symbol{"N", true, {kForce}},
    Symbol{"s", true, {{0.0, 0.0, 1.0, 0.0}}},
    Symbol{"rad", true, {{0.0, 0.0, 0.0, 1.0}}},
    Symbol{"Hz", true, {{0.0, 0.0, -1.0, 0.0}}},
    Symbol{"tf", true, {kForce, -2.0, 0.0, 1.0}},
    Symbol{"deg", false, {{0.0, 0.0, 0.0, 1.0}, 0.0, 0.0, 0.0, 1.0}},
    Symbol{"min", false, {{0.0, 0.0, 1.0, 0.0}, 1.0, 1.0}},
    Symbol{"h", false, {{0.0, 0.0, 1.0, 0.0}, 2.0, 2.0}},
    Symbol{"%", false, {{}, -2.0}},
};

constexpr std::array<std::pair<std::string_view, double>, 10> kPrefixes = {
    {{"n", -9.0}, {"u", -6.0}, {"\u00b5", -6.0}, {"\u03bc", -6.0}, {"m", -3.0}, {"c", -2.0}, {"d", -1.0}, {"k", 3.0},
     {"M", 6.0}, {"G", 9.0}}};

// What people write who mean one of ours; different spellings beyond upper and lower case.
constexpr std::array<std::pair<std::string_view, std::string_view>, 12> kSpellings = {
    {{"sec", "s"}, {"hr", "h"}, {"kmh", "km/h"}, {"kph", "km/h"}, {"ton", "t"}, {"tons", "t"}, {"tonne", "t"},
     {"to", "t"}, {"kgf", "tf"}, {"degree", "deg"}, {"degrees", "deg"}, {"\u00b0", "deg"}}};

std::optional<Unit> lookUp(std::string_view text) {
  for (const Symbol& symbol : kSymbols) {
    if (symbol.text == text) return symbol.unit;
  }
  for (const Symbol& symbol : kSymbols) {
    if (!symbol.takes_prefix || !text.ends_with(symbol.text)) continue;
    for (const auto& [prefix, power] : kPrefixes) {
      if (text.size() != prefix.size() + symbol.text.size() || !text.starts_with(prefix)) continue;
      Unit unit = symbol.unit;
      unit.ten += power;
      return unit;
    }
  }
  return std::nullopt;
}

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

// The unit that was probably meant: other spelling, other case ("KN"), a product without its sign ("kNm").
std::string suggestionFor(std::string_view text) {
  for (const auto& [spelling, meant] : kSpellings) {
    if (lowerCase(text) == spelling) return std::string(meant);
  }
  for (const Symbol& symbol : kSymbols) {
    if (lowerCase(symbol.text) == lowerCase(text)) return std::string(symbol.text);
    if (!symbol.takes_prefix) continue;
    for (const auto& [prefix, power] : kPrefixes) {
      const std::string unit = std::string(prefix) + std::string(symbol.text);
      if (lowerCase(unit) == lowerCase(text)) return unit;
    }
  }
  for (std::size_t cut = 1; cut < text.size() && text.size() <= 8; ++cut) {
    if (lookUp(text.substr(0, cut)) && lookUp(text.substr(cut))) {
      return std::string(text.substr(0, cut)) + '*' + std::string(text.substr(cut));
    }
  }
  return "";
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
    if (!found) {
      const std::string suggestion = suggestionFor(text);
      return fail("has the unknown unit " + quoted(text),
                  suggestion.empty() ? "" : "did you mean \"" + suggestion + "\"?");
    }
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
