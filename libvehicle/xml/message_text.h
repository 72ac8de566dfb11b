#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace vehicle {

/// Length of the UTF-8 sequence at the front of `text`; 0 if there is none.
/// Source: RFC 3629, section 4 (no overlong forms, no surrogates, nothing above U+10FFFF).
[[nodiscard]] std::size_t sequenceLength(std::string_view text);

/// Text of a file for a message: on one line, and cut after about 60 characters.
[[nodiscard]] std::string shown(std::string_view text);

/// "a, b, c" for separator ", ".
[[nodiscard]] std::string joined(const std::vector<std::string>& words, std::string_view separator);

}  // namespace vehicle
