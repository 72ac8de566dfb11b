#include "libvehicle/storage/csv_text.h"

#include <array>
#include <charconv>
#include <set>

#include <fmt/format.h>

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
  // -0 + 0 = 0: the sign of zero says nothing, and readers stumble over "-0".
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value + 0.0);
  line.append(text.data(), end);
}

std::string_view takeLine(std::string_view& rest) {
  const std::size_t end = rest.find_first_of("\r\n");
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(line.size());
  rest.remove_prefix(rest.starts_with("\r\n") ? 2 : rest.empty() ? 0 : 1);
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

std::string_view trimmed(std::string_view field) {
  const std::size_t first = field.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return field.substr(first, field.find_last_not_of(" \t") - first + 1);
}

std::optional<Channel> channelOf(std::string_view field) {
  field = trimmed(field);
  const std::size_t bracket = field.rfind(" [");
  if (bracket == std::string_view::npos || bracket == 0 || !field.ends_with(']')) return std::nullopt;
  return Channel{std::string(field.substr(0, bracket)),
                 std::string(field.substr(bracket + 2, field.size() - bracket - 3))};
}

std::vector<Channel> takeHeader(std::string_view& rest, const std::string& file, const std::string& example,
                                ProblemList& problems) {
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
  const Place place{file, 1};
  std::vector<Channel> channels;
  const auto fields = splitFields(takeLine(rest));
  if (!fields) {
    problems.add(place, "", "a quote in the header is never closed", "");
    return channels;
  }
  std::set<std::string> names;
  for (const std::string& field : *fields) {
    if (problems.size() >= kMostCsvProblems) break;
    const std::optional<Channel> channel = channelOf(field);
    if (!channel) {
      problems.add(place, "", fmt::format("column \"{}\" has no name with a unit in brackets", field), example);
    } else if (!names.insert(channel->name).second) {
      problems.add(place, "", fmt::format("column \"{}\" stands there twice", channel->name), "");
    }
    channels.push_back(channel.value_or(Channel{}));
  }
  return channels;
}

}  // namespace vehicle
