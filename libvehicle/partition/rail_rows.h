#pragma once

#include <vector>

#include "libvehicle/partition/equation_graph.h"
#include "libvehicle/partition/step_walk.h"

namespace vehicle {

/// The rows of the input as one thread reads them, each when the thread has time for it: its own channels only.
class OwnRows {
 public:
  /// @param channels  that enter the thread's equations
  OwnRows(const Input& input, ChannelRun channels)
      : input_(input), channels_(channels), row_{Row(channels), Row(channels), Row(channels)} {}

  void enter(const StepBlock& steps) {
    steps.wind(input_, clock_);
    read(0, row_[2]);
  }
  /// Begins step k; its first row is the last of the step before.
  void beginStep(int k) {
    row_[0].swap(row_[2]);
    sample_ = 2 * k;
  }
  void readMiddle() { read(sample_ + 1, row_[1]); }
  void readEnd() { read(sample_ + 2, row_[2]); }

  /// The row at the begin (0), middle (1) or end (2) of the step, of channels() alone.
  [[nodiscard]] const double* row(int which) const { return row_[which].data(); }
  [[nodiscard]] ChannelRun channels() const { return channels_; }

 private:
  using Values = std::vector<double>;
  static Values Row(ChannelRun channels) { return Values(static_cast<std::size_t>(2 * channels.size())); }
  void read(int sample, Values& row) {
    if (channels_.size() > 0) input_.readRow(clock_, sample, channels_.first, channels_.last, row.data());
  }

  const Input& input_;
  ChannelRun channels_;
  SweepClock clock_;
  Values row_[3];
  int sample_ = 0;
};

/// The rows of all channels, swept by one thread for all, block by block of the walk; two blocks are there at a time.
class SharedRows {
 public:
  static constexpr int kSteps = Input::kBlock / 2;  // of a block of the walk

  explicit SharedRows(const Input& input)
      : input_(input), width_(2 * static_cast<std::size_t>(input.channels())) {
    for (auto& block : blocks_) block.resize((2 * static_cast<std::size_t>(kSteps) + 1) * width_);
  }

  /// @param number  of the block, counted over the whole walk
  void sweep(long number, const StepBlock& steps) {
    const auto samples = static_cast<std::size_t>(2 * (steps.last - steps.first) + 1);
    input_.sweep(steps.segment, steps.begin, 0.5 * steps.h, 2 * steps.first, static_cast<int>(samples),
                 {block(number).data(), samples * width_});
  }
  [[nodiscard]] const double* row(long number, int sample) const {
    return blocks_[number % 2].data() + static_cast<std::size_t>(sample) * width_;
  }

 private:
  std::vector<double>& block(long number) { return blocks_[number % 2]; }

  const Input& input_;
  std::size_t width_;
  std::vector<double> blocks_[2];
};

}  // namespace vehicle
