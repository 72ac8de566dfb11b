#include "libvehicle/units/decimal.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <limits>

namespace vehicle {

namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

// An exponent beyond this is out of range of any double whatever the digits; counting on would overflow.
constexpr long kExponentCap = 1'000'000'000;

std::string_view cutDigits(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), isDigit);
  const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(digits.size());
  return digits;
}

// "e-3" at the head of the text; an "e" without digits is no exponent, it may start a unit.
long cutExponent(std::string_view& text) {
  std::string_view rest = text;
  if (rest.empty() || (rest.front() != 'e' && rest.front() != 'E')) return 0;
  rest.remove_prefix(1);
  const bool negative = !rest.empty() && rest.front() == '-';
  if (!rest.empty() && (rest.front() == '-' || rest.front() == '+')) rest.remove_prefix(1);
  const std::string_view digits = cutDigits(rest);
  if (digits.empty()) return 0;
  text = rest;
  long value = 0;
  for (const char digit : digits) value = std::min(10 * value + (digit - '0'), kExponentCap);
  return negative ? -value : value;
}

void dropOuterZeros(Decimal& decimal) {
  decimal.digits.erase(0, std::min(decimal.digits.find_first_not_of('0'), decimal.digits.size()));
  while (!decimal.digits.empty() && decimal.digits.back() == '0') {
    decimal.digits.pop_back();
    ++decimal.exponent;
  }
  if (decimal.digits.empty()) decimal.exponent = 0;
}

}  // namespace

void Decimal::multiply(unsigned long factor) {
  assert(factor > 0 && factor <= 1'000'000'000);
  unsigned long carry = 0;
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit) {
    carry += factor * static_cast<unsigned long>(*digit - '0');
    *digit = static_cast<char>('0' + carry % 10);
    carry /= 10;
  }
  if (carry > 0) digits.insert(0, std::to_string(carry));
}

double Decimal::nearest() const {
  if (digits.empty()) return negative ? -0.0 : 0.0;
  const std::string text = (negative ? "-" : "") + digits + 'e' + std::to_string(exponent);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc::result_out_of_range) return value;
  // from_chars leaves the value alone in both directions; the place of the leading digit tells which it was.
  const double magnitude =
      static_cast<long>(digits.size()) + exponent > 0 ? std::numeric_limits<double>::infinity() : 0.0;
  return negative ? -magnitude : magnitude;
}

std::string Decimal::text() const {
  const std::string sign = negative ? "-" : "";
  if (digits.empty()) return sign + '0';
  const long size = static_cast<long>(digits.size());
  const long point = size + exponent;  // the decimal point stands after this many digits
  if (point > 15 || point < -3) {
    std::string mantissa = digits.substr(0, 1);
    if (size > 1) mantissa += '.' + digits.substr(1);
    return sign + mantissa + 'e' + std::to_string(point - 1);
  }
  if (point <= 0) return sign + "0." + std::string(static_cast<std::size_t>(-point), '0') + digits;
  if (point >= size) return sign + digits + std::string(static_cast<std::size_t>(point - size), '0');
  const auto whole = static_cast<std::size_t>(point);
  return sign + digits.substr(0, whole) + '.' + digits.substr(whole);
}

std::optional<Decimal> cutDecimal(std::string_view& text) {
  std::string_view rest = text;
  Decimal decimal;
  if (!rest.empty() && (rest.front() == '-' || rest.front() == '+')) {
    decimal.negative = rest.front() == '-';
    rest.remove_prefix(1);
  }
  decimal.digits = cutDigits(rest);
  if (!rest.empty() && rest.front() == '.') {
    std::string_view after = rest.substr(1);
    const std::string_view fraction = cutDigits(after);
    if (decimal.digits.empty() && fraction.empty()) return std::nullopt;
    decimal.digits += fraction;
    decimal.exponent = -static_cast<long>(fraction.size());
    rest = after;
  }
  if (decimal.digits.empty()) return std::nullopt;
  decimal.exponent += cutExponent(rest);
  dropOuterZeros(decimal);
  text = rest;
  return decimal;
}

Decimal shortestDecimal(double value) {
  std::array<char, 64> buffer{};
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific);
  assert(error == std::errc());  // 17 digits and an exponent fit
  std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  const std::optional<Decimal> decimal = cutDecimal(text);
  assert(decimal.has_value());  // finite: the caller's promise
  return *decimal;
}

}  // namespace vehicle
