#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vehicle {

// Comma-separated text (RFC 4180), the pieces that every table of ours is read and written with.

/// Appends a field; only a text that needs it is quoted: a comma in a name would shift every later column.
void appendField(std::string& line, std::string_view text);
/// Appends the shortest text that reads back to the same bits.
void appendNumber(std::string& line, double value);

/// Cuts the next line off `rest`, without its end (LF or CR LF).
[[nodiscard]] std::string_view takeLine(std::string_view& rest);
/// Fields of a line, quotes removed; nothing if a quote stays open.
[[nodiscard]] std::optional<std::vector<std::string>> splitFields(std::string_view line);

/// "carbody.z [m]" taken apart; nothing if there is no name or no unit in brackets. A plain number has "[]".
struct NamedColumn {
  std::string name;
  std::string unit;
};
[[nodiscard]] std::optional<NamedColumn> columnOf(std::string_view field);

}  // namespace vehicle
