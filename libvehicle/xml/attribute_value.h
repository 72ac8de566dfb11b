#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "libvehicle/xml/schema.h"

namespace vehicle {

/// One attribute's text, judged by its row of the schema.
struct AttributeReading {
  Value value;          // usable even if the text is wrong: some value in range, so that later checks find no
                        // second fault in the same place
  std::string message;  // empty: all is well
  std::string remedy;
};

[[nodiscard]] AttributeReading readAttribute(const AttributeRow& row, std::string_view text);

/// A value in range for an attribute that is missing or wrong; monostate for names and references, without which
/// nothing can be said about the whole.
[[nodiscard]] Value standInFor(const AttributeRow& row);

/// The text that readAttribute() reads back to the same value.
/// @throws std::invalid_argument if a quantity is not finite
[[nodiscard]] std::string attributeText(const AttributeRow& row, const Value& value);

/// The nearest of the candidates for a person who mistyped. Words of one or two letters and very long ones are no
/// typing errors.
[[nodiscard]] std::optional<std::string> suggestion(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace vehicle
