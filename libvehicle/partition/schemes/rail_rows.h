#pragma once

#include <vector>

#include "libvehicle/integrate/step_walk.h"
#include "libvehicle/partition/map/equation_graph.h"

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

}  // namespace vehicle
