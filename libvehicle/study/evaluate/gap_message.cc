#include "libvehicle/study/evaluate/gap_message.h"

#include <algorithm>

namespace vehicle {

namespace {

constexpr std::string_view kBetween = " | ";

}  // namespace

std::string gapMessage(const std::vector<Channel>& columns, const std::map<std::size_t, std::string>& missing) {
  struct Part {
    std::string metrics;
    const std::string* reason;
  };
  std::vector<Part> parts;
  for (const auto& gap : missing) {
    const std::string& reason = gap.second;
    const std::string& name = columns[gap.first].name;
    const auto same =
        std::find_if(parts.begin(), parts.end(), [&](const Part& each) { return *each.reason == reason; });
    if (same == parts.end()) {
      parts.push_back({name, &reason});
    } else {
      same->metrics.append(", ").append(name);
    }
  }
  std::string message;
  for (const Part& each : parts) {
    if (!message.empty()) message.append(kBetween);
    message.append(each.metrics).append(": ").append(*each.reason);
  }
  return message;
}

std::vector<std::string_view> gapsIn(std::string_view message) {
  std::vector<std::string_view> gaps;
  while (!message.empty()) {
    const std::size_t end = std::min(message.find(kBetween), message.size());
    gaps.push_back(message.substr(0, end));
    message.remove_prefix(std::min(end + kBetween.size(), message.size()));
  }
  return gaps;
}

}  // namespace vehicle
