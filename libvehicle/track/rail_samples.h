#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace vehicle {

/// Heights of a rail at equally spaced distances, wherever they are kept: in memory, or in a file of any length of which
/// a reader asks for a few thousand at a time.
class RailSamples {
 public:
  virtual ~RailSamples() = default;

  [[nodiscard]] virtual std::int64_t count() const = 0;
  /// Heights [m] of the samples first .. first + heights.size() - 1, all of them within the count. Never called by two
  /// threads at once.
  virtual void read(std::int64_t first, std::span<double> heights) = 0;
};

/// Samples that are in memory: 8 bytes each.
class StoredSamples final : public RailSamples {
 public:
  explicit StoredSamples(std::vector<double> heights) : heights_(std::move(heights)) {}
  [[nodiscard]] std::int64_t count() const override { return static_cast<std::int64_t>(heights_.size()); }
  void read(std::int64_t first, std::span<double> heights) override;

 private:
  std::vector<double> heights_;  // [m]
};

}  // namespace vehicle
