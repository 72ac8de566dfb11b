#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vehicle {

/// Metrics that designs lack for one reason.
struct MissingValues {
  std::string metrics;  // "mode.carbody pitch.frequency, mode.carbody pitch.damped_frequency"
  std::string reason;
  std::uint64_t designs = 0;
};

/// Counts designs that lack values by their reasons, in memory that does not grow with the designs.
class MissingCount {
 public:
  /// @param metrics  of a design that is done, NaN where there is no value
  /// @param message  of the design (gap_message.h)
  void add(std::span<const double> metrics, std::string_view message);

  /// Designs that lack at least one value.
  [[nodiscard]] std::uint64_t designs() const { return designs_; }
  /// @param most  of them, >= 0
  [[nodiscard]] std::vector<MissingValues> mostFrequent(std::size_t most) const;

 private:
  std::uint64_t designs_ = 0;
  std::map<std::string, std::uint64_t, std::less<>> counts_;  // by metrics and reason
};

}  // namespace vehicle
