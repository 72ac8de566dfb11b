#include "libvehicle/report/document/text_wrap.h"

#include <algorithm>
#include <sstream>

namespace vehicle::report {

std::size_t lettersOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string trimmed(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

std::vector<std::string> linesOf(const std::vector<std::string>& pieces, std::size_t width) {
  std::vector<std::string> lines(1);
  for (const std::string& each : pieces) {
    if (!lines.back().empty() && lettersOf(trimmed(lines.back() + each)) > width) lines.emplace_back();
    lines.back() += each;
  }
  for (std::string& line : lines) line = trimmed(std::move(line));
  return lines;
}

std::vector<std::string> wordsOf(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = i == 0 || (text[i] != ' ' && text[i - 1] == ' ');
    if (begins) words.emplace_back();
    words.back() += text[i];
  }
  return words;
}

std::vector<std::string> partsOfName(const std::string& name) {
  std::vector<std::string> parts(1);
  bool whole = false;
  for (const char letter : name) {
    if (letter == '[' && !parts.back().empty()) parts.emplace_back();
    parts.back() += letter;
    if (letter == '(' || letter == '@') whole = true;
    if (letter == ')' || letter == '[') whole = false;
    if (!whole && (letter == '.' || letter == ' ')) parts.emplace_back();
  }
  return parts;
}

std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
  const std::size_t room = width > indent ? width - indent : 1;
  std::istringstream stream(text);
  std::string all;
  for (std::string line; std::getline(stream, line);) {
    for (const std::string& each : linesOf(wordsOf(line), room)) {
      if (!all.empty()) all += '\n' + std::string(each.empty() ? 0 : indent, ' ');
      all += each;
    }
  }
  return all;
}

std::string wrappedPage(const std::string& text, std::size_t width) {
  std::istringstream stream(text);
  std::string page;
  for (std::string line; std::getline(stream, line);) {
    const bool is_command = line.starts_with("Example: ") || line.starts_with(' ') || line.ends_with('\\');
    page += (is_command ? line : wrapped(line, width)) + '\n';
  }
  return page;
}

std::string twoColumns(const std::vector<std::pair<std::string, std::string>>& lines, std::size_t width) {
  std::size_t left_width = 0;
  for (const auto& [left, right] : lines) left_width = std::max(left_width, left.size());
  std::string text;
  for (const auto& [left, right] : lines) {
    text += "  " + left + std::string(left_width - left.size() + 2, ' ') + wrapped(right, width, left_width + 4) + '\n';
  }
  return text;
}

}  // namespace vehicle::report
