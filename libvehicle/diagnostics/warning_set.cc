#include "libvehicle/diagnostics/warning_set.h"

#include <algorithm>

namespace vehicle {

std::vector<WarningCode> WarningSet::codes() const {
  std::vector<WarningCode> found;
  for (const WarningKind& each : warningKinds()) {
    if (contains(each.code)) found.push_back(each.code);
  }
  return found;
}

std::string WarningSet::words() const {
  std::string text;
  for (const WarningCode each : codes()) {
    if (!text.empty()) text += ' ';
    text += wordOf(each);
  }
  return text;
}

WarningSet WarningSet::ofWords(std::string_view words) {
  WarningSet set;
  while (!words.empty()) {
    const std::string_view word = words.substr(0, words.find(' '));
    words.remove_prefix(std::min(word.size() + 1, words.size()));
    for (const WarningKind& each : warningKinds()) {
      if (each.word == word) set.insert(each.code);
    }
  }
  return set;
}

}  // namespace vehicle
