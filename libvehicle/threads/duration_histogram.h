#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace vehicle {

/// What a histogram of durations says, in seconds.
struct DurationSummary {
  struct Bin {
    double begin = 0.0;  // [s]
    double end = 0.0;    // [s]
    long count = 0;
  };
  long count = 0;
  double least = 0.0;  // [s] exact, as `most` and `mean`
  double mean = 0.0;   // [s]
  double p50 = 0.0;    // [s] quantiles: within 1/32 of the value
  double p99 = 0.0;
  double p999 = 0.0;
  double most = 0.0;
  std::vector<Bin> bins{};  // those that are not empty, rising
};

/// Counts durations in bins of equal ratio: 16 in every octave, whatever the size. Recording is a shift and an
/// increment; the memory is fixed.
class DurationHistogram {
 public:
  /// @param ticks  any unit of time; summary() turns it into seconds
  void record(std::uint64_t ticks) {
    ++counts_[binOf(ticks)];
    ++count_;
    sum_ += static_cast<double>(ticks);
    if (ticks < least_) least_ = ticks;
    if (ticks > most_) most_ = ticks;
  }

  [[nodiscard]] long count() const { return count_; }
  [[nodiscard]] std::uint64_t most() const { return most_; }  // [ticks]

  /// Smallest duration [ticks] that a share p of all does not exceed: the middle of its bin; 0 if there are none.
  /// @param p  0..1
  [[nodiscard]] double quantile(double p) const;

  [[nodiscard]] DurationSummary summary(double seconds_per_tick) const;

 private:
  static constexpr unsigned kBits = 4;
  static constexpr std::uint64_t kPerOctave = 1u << kBits;

  // Below 16 every tick has its bin; above, the leading 1 and the four bits after it choose.
  static std::size_t binOf(std::uint64_t ticks) {
    if (ticks < kPerOctave) return ticks;
    const auto shift = static_cast<unsigned>(std::bit_width(ticks)) - kBits - 1;
    return (shift + 1) * kPerOctave + (ticks >> shift) - kPerOctave;
  }
  static double beginOf(std::size_t bin);

  std::array<long, (64 - kBits + 1) * kPerOctave> counts_{};
  long count_ = 0;
  double sum_ = 0.0;
  std::uint64_t least_ = ~std::uint64_t{0};
  std::uint64_t most_ = 0;
};

}  // namespace vehicle
