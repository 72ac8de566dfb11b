#pragma once

#include <string>
#include <string_view>

namespace vehicle {

/// A text as it stands in XML, between tags or in an attribute, so that it is read back the same: & < > " as entities,
/// tabs and line breaks as character numbers, since an attribute would give them back as spaces.
[[nodiscard]] std::string xmlEscaped(std::string_view text);

}  // namespace vehicle
