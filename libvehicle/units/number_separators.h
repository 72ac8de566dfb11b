#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace vehicle {

/// What is wrong with a number that holds separators, in the words of ParsedQuantity.
struct SeparatedNumber {
  std::string message;  // e.g. `has a thousands separator`
  std::string remedy;   // e.g. `write "57000 kg"`
};

/// Recognises thousands separators (57,000; 57 000; 57'000; 57_000; 1.234.567) and decimal commas (3,5) at the head of a
/// value. "57,000" may be either: then both readings are named.
/// @param text  a value whose number begins at its first byte, e.g. "57 000 kg"
/// @returns nothing for a number without any of them, and for what is no number either way, e.g. "1.2.3"
[[nodiscard]] std::optional<SeparatedNumber> separatorsIn(std::string_view text);

}  // namespace vehicle
