#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <vector>

#include "libvehicle/ensemble/design.h"
#include "libvehicle/ensemble/kernel.h"

namespace vehicle::ensemble {

/// Doubles aligned as the kernels want them, all 0 at first.
class AlignedDoubles {
 public:
  static constexpr std::size_t kAlignment = 64;  // [bytes] one AVX-512 register
  AlignedDoubles() = default;
  explicit AlignedDoubles(std::size_t size)
      : values_(size == 0 ? nullptr : new (std::align_val_t{kAlignment}) double[size]()), size_(size) {}
  [[nodiscard]] double* data() { return values_.get(); }
  [[nodiscard]] const double* data() const { return values_.get(); }
  [[nodiscard]] std::size_t size() const { return size_; }
  double& operator[](std::size_t i) { return values_[i]; }
  double operator[](std::size_t i) const { return values_[i]; }

 private:
  struct Free {
    void operator()(double* values) const { ::operator delete[](values, std::align_val_t{kAlignment}); }
  };
  std::unique_ptr<double[], Free> values_;
  std::size_t size_ = 0;
};

/// Columns of a run as the kernels read them.
/// @throws std::invalid_argument for a column that does not exist
class ColumnChoice {
 public:
  explicit ColumnChoice(std::span<const FlatColumn> columns);
  [[nodiscard]] Choice get() const;
  [[nodiscard]] int count() const { return static_cast<int>(columns_.size()); }

 private:
  std::vector<int> columns_;
  Choice flags_;
};

/// Designs laid out lane beside lane, with the room for what is gathered of them. The last block is filled up with
/// copies of its last design, whose results nobody reads.
class BlockRows {
 public:
  /// @param order  (lanes used) index of the design that each lane holds, not empty
  /// @param packs  the number of blocks is a multiple of it
  BlockRows(std::span<const EnsembleDesign> designs, std::span<const int> order, int lanes, int columns,
            int packs = 1);

  [[nodiscard]] int blocks() const { return blocks_; }
  [[nodiscard]] int lanes() const { return lanes_; }
  [[nodiscard]] int used() const { return used_; }
  [[nodiscard]] Block block(int index);
  [[nodiscard]] SteadyBlock steadyBlock(int index);

  /// One number of what was gathered. @param lane  0 .. used() - 1   @param metric  0 .. kMetricRows - 1
  [[nodiscard]] double metric(int lane, int column, int metric) const;
  /// @param row  of kRangeRows
  [[nodiscard]] double range(int lane, int row) const;
  /// Number of the first sample that is not finite, or infinity.
  [[nodiscard]] double failedAt(int lane) const;

 private:
  [[nodiscard]] std::size_t offset(int block, int rows) const;

  int lanes_, used_, columns_, blocks_;
  AlignedDoubles coefficients_, extra_, masses_, state_, metrics_, range_, failed_;
};

}  // namespace vehicle::ensemble
