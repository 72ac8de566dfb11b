#include "libvehicle/units/number_separators.h"

#include <algorithm>
#include <array>
#include <vector>

namespace vehicle {

namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

// Apostrophes and spaces as keyboards and typesetters have them: ' ’ space, no-break space, thin and narrow spaces.
constexpr std::array<std::string_view, 10> kSeparators = {",",      ".",      "'",      "_",      " ",
                                                          "\u2019", "\u00a0", "\u2009", "\u202f", "\u2007"};

/// "57 000.5" taken apart: groups of digits, and what stands between them.
struct Groups {
  std::string sign;
  std::vector<std::string> digits;
  std::vector<std::string_view> between;
  std::string_view rest;  // behind the last digit
};

std::string_view cutDigits(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), isDigit);
  const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(digits.size());
  return digits;
}

Groups groupsOf(std::string_view text) {
  Groups groups;
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) {
    groups.sign = text[0];
    text.remove_prefix(1);
  }
  groups.digits.emplace_back(cutDigits(text));
  for (bool more = true; more;) {
    more = false;
    for (const std::string_view separator : kSeparators) {
      if (!text.starts_with(separator)) continue;
      const std::string_view after = text.substr(separator.size());
      std::size_t digits = 0;
      while (digits < after.size() && isDigit(after[digits])) ++digits;
      // Behind a space anything else than three digits belongs to the unit: "3 1/s".
      const bool is_point = separator == "," || separator == ".";
      if (digits == 0 || (digits != 3 && !is_point)) continue;
      groups.between.push_back(separator);
      text.remove_prefix(separator.size());
      groups.digits.emplace_back(cutDigits(text));
      more = true;
      break;
    }
  }
  groups.rest = text;
  return groups;
}

/// The number with a decimal point before its last `decimals` groups (0 or 1) and nothing else between them.
std::string joined(const Groups& groups, std::size_t decimals) {
  std::string number = groups.sign;
  for (std::size_t i = 0; i < groups.digits.size(); ++i) {
    if (i + decimals == groups.digits.size()) number += '.';
    number += groups.digits[i];
  }
  return '"' + number + std::string(groups.rest) + '"';
}

/// Whether groups 1 .. last - 1 have three digits and the first has one to three.
bool areThousands(const Groups& groups, std::size_t last) {
  const std::size_t lead = groups.digits.front().size();
  return lead >= 1 && lead <= 3 &&
         std::all_of(groups.digits.begin() + 1, groups.digits.begin() + static_cast<std::ptrdiff_t>(last),
                     [](const std::string& each) { return each.size() == 3; });
}

}  // namespace

std::optional<SeparatedNumber> separatorsIn(std::string_view text) {
  const Groups groups = groupsOf(text);
  const std::size_t count = groups.between.size();
  if (count == 0 || (count == 1 && groups.between[0] == ".")) return std::nullopt;
  const std::string_view last = groups.between.back();
  const bool may_be_decimal =
      (last == "," || last == ".") && std::count(groups.between.begin(), groups.between.end(), last) == 1;
  const bool thousands = areThousands(groups, count + 1);
  if (count == 1 && last == ",") {
    if (!thousands || groups.digits[0] == "0") {
      return SeparatedNumber{"has a comma in its number", "the decimal sign is a point: write " + joined(groups, 1)};
    }
    return SeparatedNumber{"has a thousands separator or a decimal comma",
                           "write " + joined(groups, 0) + ", or " + joined(groups, 1) + " if the comma is decimal"};
  }
  const std::string remedy = "write the number without it, ";
  // A decimal sign differs from what separates the thousands before it.
  if (may_be_decimal && count > 1 && areThousands(groups, count)) {
    return SeparatedNumber{"has a thousands separator", remedy + joined(groups, 1)};
  }
  if (thousands) return SeparatedNumber{"has a thousands separator", remedy + joined(groups, 0)};
  return std::nullopt;
}

}  // namespace vehicle
