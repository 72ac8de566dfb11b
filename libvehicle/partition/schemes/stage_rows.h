#pragma once

// Rows of the rail for the threads of a stage exchange, made while others' values are on their way.
//
//   a step    f  show | await   f  show | await   f  show | await   f  show | await
//   rows              middle            clock             end
//
// A step shows four times and then waits for the way of a line. What is done between showing and looking costs nothing
// as long as it is shorter than that way: the row of the middle, a part of the clock of the next block, the row of the
// end. A thread that reads no channel makes no rows.

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "libvehicle/partition/schemes/rail_rows.h"

namespace vehicle {

/// The blocks of a walk of SweptRows::kSteps steps a block, one after the other, ahead of the walk itself.
class BlocksAhead {
 public:
  explicit BlocksAhead(const StepWalk& way) {
    constexpr int kWholeGrid = 1 << 30;
    walkSteps(
        {way.schedule, way.step, kWholeGrid}, [&](const StepBlock& grid) { grids_.push_back(grid); },
        [](double, int) {}, [](const StepPause&) { return true; });
  }
  [[nodiscard]] std::optional<StepBlock> next() {
    if (grid_ == grids_.size()) return std::nullopt;
    StepBlock block = grids_[grid_];
    block.first = done_;
    block.last = std::min(done_ + SweptRows::kSteps, block.last);
    done_ = block.last;
    if (done_ == grids_[grid_].last) {
      done_ = 0;
      ++grid_;
    }
    return block;
  }

 private:
  std::vector<StepBlock> grids_;  // each as one block
  std::size_t grid_ = 0;
  int done_ = 0;  // steps of it
};

/// A thread's own rows, of the channels that enter its equations; none where none does.
class AheadRows {
 public:
  AheadRows(const Input& input, ChannelRun channels, const StepWalk& way) : input_(input), channels_(channels) {
    for (Values& row : row_) row.resize(static_cast<std::size_t>(2 * channels.size()));
    if (channels_.size() == 0) return;
    ahead_.emplace(way);
    windNext();
  }

  void enter(const StepBlock&) {
    if (channels_.size() == 0) return;
    if (!wound_) windNext();
    std::swap(clock_, next_);
    wound_ = false;
    read(0, row_[2]);
  }
  /// Begins step k of the block; its first row is the last of the step before.
  void beginStep(int k) {
    row_[0].swap(row_[2]);
    sample_ = 2 * k;
  }
  /// After stage 0 .. 3 has been shown.
  void afterStage(int stage) {
    if (channels_.size() == 0) return;
    if (stage == 0) {
      read(sample_ + 1, row_[1]);
    } else if (stage == 1) {
      if (!wound_) windNext();
    } else if (stage == 2) {
      read(sample_ + 2, row_[2]);
    }
  }
  /// At the begin (0), middle (1) or end (2) of the step, of channels() alone.
  [[nodiscard]] const double* row(int which) const { return row_[which].data(); }
  [[nodiscard]] ChannelRun channels() const { return channels_; }

 private:
  using Values = std::vector<double>;
  void windNext() {
    if (const std::optional<StepBlock> block = ahead_->next()) block->prepare(input_, next_);
    wound_ = true;
  }
  void read(int sample, Values& row) {
    input_.readRow(clock_, sample, channels_.first, channels_.last, row.data());
  }

  const Input& input_;
  ChannelRun channels_;
  std::optional<BlocksAhead> ahead_;
  PhasorTable clock_;
  PhasorTable next_;
  bool wound_ = false;  // next_, or there is none
  Values row_[3];
  int sample_ = 0;
};

/// Rows that one thread of the team sweeps a block ahead for all: two blocks, that in use and the next.
class SharedRows {
 public:
  /// @param sweeper  of the thread that does it, else nullptr
  SharedRows(std::vector<SweptRows>& rows, ChannelRun channels, BlocksAhead* sweeper)
      : rows_(rows), channels_(channels), sweeper_(sweeper) {}

  /// Fills the place of block `number` of the walk, if there is such a block.
  static void sweep(std::vector<SweptRows>& rows, BlocksAhead& ahead, long number) {
    if (const std::optional<StepBlock> block = ahead.next()) rows[static_cast<std::size_t>(number % 2)].sweep(*block);
  }

  void enter(const StepBlock&) { swept_ = &rows_[static_cast<std::size_t>(++block_ % 2)]; }
  void beginStep(int k) { sample_ = 2 * k; }
  /// While the first values of the block are on their way: every reader has done with the block before.
  void afterStage(int stage) {
    if (sweeper_ == nullptr || stage != 0 || done_ > block_) return;
    done_ = block_ + 1;
    sweep(rows_, *sweeper_, done_);
  }
  [[nodiscard]] const double* row(int which) const { return swept_->row(sample_ + which); }
  [[nodiscard]] ChannelRun channels() const { return channels_; }

 private:
  std::vector<SweptRows>& rows_;
  const SweptRows* swept_ = nullptr;
  ChannelRun channels_;
  BlocksAhead* sweeper_;
  long block_ = -1;
  long done_ = 0;  // blocks swept ahead
  int sample_ = 0;
};

}  // namespace vehicle
