#include "libvehicle/threads/duration_histogram.h"

#include <algorithm>
#include <cmath>

namespace vehicle {

double DurationHistogram::beginOf(std::size_t bin) {
  if (bin < kPerOctave) return static_cast<double>(bin);
  const auto shift = static_cast<int>(bin / kPerOctave) - 1;
  return std::ldexp(static_cast<double>(kPerOctave + bin % kPerOctave), shift);
}

double DurationHistogram::quantile(double p) const {
  if (count_ == 0) return 0.0;
  const double rank = std::clamp(std::ceil(p * static_cast<double>(count_)), 1.0, static_cast<double>(count_));
  double reached = 0.0;
  for (std::size_t bin = 0; bin < counts_.size(); ++bin) {
    reached += static_cast<double>(counts_[bin]);
    if (reached < rank) continue;
    // Whole ticks: the last one of a bin is one below the begin of the next.
    const double middle = 0.5 * (beginOf(bin) + beginOf(bin + 1) - 1.0);
    return std::clamp(middle, static_cast<double>(least_), static_cast<double>(most_));
  }
  return static_cast<double>(most_);
}

DurationSummary DurationHistogram::summary(double seconds_per_tick) const {
  DurationSummary told;
  if (count_ == 0) return told;
  told.count = count_;
  told.least = seconds_per_tick * static_cast<double>(least_);
  told.mean = seconds_per_tick * sum_ / static_cast<double>(count_);
  told.p50 = seconds_per_tick * quantile(0.5);
  told.p99 = seconds_per_tick * quantile(0.99);
  told.p999 = seconds_per_tick * quantile(0.999);
  told.most = seconds_per_tick * static_cast<double>(most_);
  for (std::size_t bin = 0; bin < counts_.size(); ++bin) {
    if (counts_[bin] == 0) continue;
    told.bins.push_back({seconds_per_tick * beginOf(bin), seconds_per_tick * beginOf(bin + 1), counts_[bin]});
  }
  return told;
}

}  // namespace vehicle
