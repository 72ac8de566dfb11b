#include "libvehicle/xml/message_text.h"

#include <algorithm>

namespace vehicle {

std::size_t sequenceLength(std::string_view text) {
  const auto byte = [text](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const auto tail = [byte](std::size_t i) { return (byte(i) & 0xC0u) == 0x80u; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return tail(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const unsigned least = first == 0xE0 ? 0xA0 : 0x80;
    const unsigned most = first == 0xED ? 0x9F : 0xBF;
    return byte(1) >= least && byte(1) <= most && tail(2) ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const unsigned least = first == 0xF0 ? 0x90 : 0x80;
    const unsigned most = first == 0xF4 ? 0x8F : 0xBF;
    return byte(1) >= least && byte(1) <= most && tail(2) && tail(3) ? 4 : 0;
  }
  return 0;
}

std::string shown(std::string_view text) {
  constexpr std::size_t kMostShown = 60;
  std::string line;
  for (std::size_t i = 0; i < text.size();) {
    if (line.size() >= kMostShown) return line + "...";
    const std::size_t length = std::max<std::size_t>(1, sequenceLength(text.substr(i)));
    const unsigned char byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x20 || byte == 0x7F) {
      line += ' ';
    } else {
      line += text.substr(i, length);
    }
    i += length;
  }
  return line;
}

std::string joined(const std::vector<std::string>& words, std::string_view separator) {
  std::string line;
  for (const std::string& word : words) {
    if (&word != &words.front()) line += separator;
    line += word;
  }
  return line;
}

}  // namespace vehicle
