#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "libvehicle/result/history_sink.h"
#include "libvehicle/units/channel.h"

namespace vehicle {

/// A table over time: column 0 is "time" [s], the others are what the run recorded. All values are SI.
class TimeHistory {
 public:
  TimeHistory() = default;
  /// @param channels  the columns after "time", in order
  /// @throws std::invalid_argument if two columns would have the same name
  explicit TimeHistory(const std::vector<Channel>& channels);

  void reserve(std::size_t samples) { values_.reserve(samples * columns_.size()); }
  /// Appends one sample, all other columns 0, and returns its row to be filled, shape (columns), row[0] = time.
  /// The span is valid until the next append.
  /// @throws std::invalid_argument on a history without columns
  std::span<double> append(double time);

  [[nodiscard]] const std::vector<Channel>& columns() const { return columns_; }
  [[nodiscard]] std::size_t samples() const { return columns_.empty() ? 0 : values_.size() / columns_.size(); }
  [[nodiscard]] double at(std::size_t sample, std::size_t column) const {
    return values_[sample * columns_.size() + column];
  }
  [[nodiscard]] std::span<const double> row(std::size_t sample) const;
  /// A copy of one column, shape (samples).
  [[nodiscard]] std::vector<double> column(std::size_t index) const;
  /// @throws std::invalid_argument naming the nearest column if there is none of that name
  [[nodiscard]] std::size_t indexOf(std::string_view name) const;
  [[nodiscard]] std::vector<double> column(std::string_view name) const { return column(indexOf(name)); }

 private:
  std::vector<Channel> columns_;
  std::vector<double> values_;  // row-major (samples x columns)
};

/// Keeps a run in memory: 8 bytes a sample and column.
class StoredHistory final : public HistorySink {
 public:
  void begin(const std::vector<Channel>& columns, long samples) override;
  void add(std::span<const double> row) override;
  [[nodiscard]] TimeHistory take() { return std::move(history_); }

 private:
  TimeHistory history_;
};

}  // namespace vehicle
