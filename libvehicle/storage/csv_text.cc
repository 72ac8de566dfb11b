#include "libvehicle/storage/csv_text.h"

#include <array>
#include <charconv>

namespace vehicle {

void appendField(std::string& line, std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    line += text;
    return;
  }
  line += '"';
  for (const char c : text) {
    if (c == '"') line += '"';
    line += c;
  }
  line += '"';
}

void appendNumber(std::string& line, double value) {
  std::array<char, 32> text;  // the longest shortest form, -2.2250738585072014e-308, has 24 characters
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  line.append(text.data(), end);
}

std::string_view takeLine(std::string_view& rest) {
  const std::size_t end = rest.find('\n');
  std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::optional<std::vector<std::string>> splitFields(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += line[i++];
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  if (quoted) return std::nullopt;
  return fields;
}

std::optional<NamedColumn> columnOf(std::string_view field) {
  const std::size_t bracket = field.rfind(" [");
  if (bracket == std::string_view::npos || bracket == 0 || !field.ends_with(']')) return std::nullopt;
  return NamedColumn{std::string(field.substr(0, bracket)),
                     std::string(field.substr(bracket + 2, field.size() - bracket - 3))};
}

}  // namespace vehicle
