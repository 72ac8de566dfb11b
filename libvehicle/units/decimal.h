#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace vehicle {

/// A decimal number kept as its digits, so that a shift by a power of ten or a whole factor costs no rounding.
///
/// value = (-1)^negative * digits * 10^exponent, digits without leading zeros ("" is zero).
struct Decimal {
  bool negative = false;
  std::string digits;
  long exponent = 0;

  /// Multiplies exactly.
  /// @param factor  1..10^9
  void multiply(unsigned long factor);

  /// The nearest double; +-inf or 0 where that is out of range. The locale has no say in it.
  [[nodiscard]] double nearest() const;

  /// "3040", "0.0085", "1.5e-09": plain where that is short, with an exponent elsewhere.
  [[nodiscard]] std::string text() const;
};

/// The number at the head of `text` ("3.7e3" of "3.7e3 m"), which is cut off it. No number: nothing is cut.
/// Accepts [+-] digits [. digits] [e [+-] digits], digits on at least one side of the point.
[[nodiscard]] std::optional<Decimal> cutDecimal(std::string_view& text);

/// The shortest decimal that reads back to the same double; `value` is finite.
[[nodiscard]] Decimal shortestDecimal(double value);

}  // namespace vehicle
