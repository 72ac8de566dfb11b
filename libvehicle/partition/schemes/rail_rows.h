#pragma once

#include <vector>

#include "libvehicle/partition/map/equation_graph.h"
#include "libvehicle/partition/schemes/step_walk.h"

namespace vehicle {

/// Few channels are swept as a whole and ahead of the steps; of many, each thread reads its own rows step by step.
[[nodiscard]] inline bool isSwept(const Input& input) { return input.channels() <= 16; }

/// Rows of all channels for one block of a walk of kSteps steps a block.
class SweptRows {
 public:
  static constexpr int kSteps = Input::kBlock / 2;

  explicit SweptRows(const Input& input)
      : input_(input),
        width_(2 * static_cast<std::size_t>(input.channels())),
        rows_((2 * static_cast<std::size_t>(kSteps) + 1) * width_) {}

  void sweep(const StepBlock& steps) {
    const int samples = 2 * (steps.last - steps.first) + 1;
    input_.sweep(steps.segment, steps.begin, 0.5 * steps.h, 2 * steps.first, samples,
                 {rows_.data(), static_cast<std::size_t>(samples) * width_});
  }
  /// @param sample  2 k, 2 k + 1, 2 k + 2 for begin, middle and end of step k of the block
  [[nodiscard]] const double* row(int sample) const { return rows_.data() + static_cast<std::size_t>(sample) * width_; }

 private:
  const Input& input_;
  std::size_t width_;
  std::vector<double> rows_;
};

/// Rows of some channels, each read when there is time for it.
class OwnRows {
 public:
  /// @param channels  that enter the thread's equations
  OwnRows(const Input& input, ChannelRun channels)
      : input_(input), channels_(channels), row_{makeRow(channels), makeRow(channels), makeRow(channels)} {}

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
  static Values makeRow(ChannelRun channels) { return Values(static_cast<std::size_t>(2 * channels.size())); }
  void read(int sample, Values& row) {
    if (channels_.size() > 0) input_.readRow(clock_, sample, channels_.first, channels_.last, row.data());
  }

  const Input& input_;
  ChannelRun channels_;
  SweepClock clock_;
  Values row_[3];
  int sample_ = 0;
};

}  // namespace vehicle
