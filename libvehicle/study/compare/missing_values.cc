#include "libvehicle/study/compare/missing_values.h"

#include <algorithm>
#include <cmath>

#include "libvehicle/study/evaluate/gap_message.h"

namespace vehicle {

namespace {

// Reasons may hold numbers of their design; it is the frequent ones that count, not every one.
constexpr std::size_t kMostReasons = 1000;

}  // namespace

void MissingCount::add(std::span<const double> metrics, std::string_view message) {
  if (std::none_of(metrics.begin(), metrics.end(), [](double each) { return std::isnan(each); })) return;
  ++designs_;
  for (const std::string_view gap : gapsIn(message)) {
    if (const auto found = counts_.find(gap); found != counts_.end()) {
      ++found->second;
    } else if (counts_.size() < kMostReasons) {
      counts_.emplace(gap, 1);
    }
  }
}

std::vector<MissingValues> MissingCount::mostFrequent(std::size_t most) const {
  std::vector<MissingValues> list;
  for (const auto& [gap, designs] : counts_) {
    const std::size_t colon = std::min(gap.find(": "), gap.size());
    list.push_back({gap.substr(0, colon), gap.substr(std::min(colon + 2, gap.size())), designs});
  }
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.designs > b.designs; });
  if (list.size() > most) list.resize(most);
  return list;
}

}  // namespace vehicle
