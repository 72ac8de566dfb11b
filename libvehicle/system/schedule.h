#pragma once

#include <functional>
#include <span>
#include <vector>

#include "libvehicle/system/input.h"

namespace vehicle {

/// A piece of a run without kink and without output sample inside.
struct Stretch {
  int segment = 0;    // of the input: the one whose formula holds on [begin, end]
  double begin = 0.0; // [s]
  double end = 0.0;   // [s]
  int sample = -1;    // number of the output sample at `end`, or -1
  int next = 0;       // the segment that holds right after `end`: what an observer of the sample there is told
};

/// Most output samples a run may have: beyond, the grid itself is no longer exact to a billionth of a step.
inline constexpr int kMostSamples = 10'000'000;

/// Number of the output sample begin + i output_step that t is, within a billionth of a step; or -1.
[[nodiscard]] int sampleAt(double begin, double output_step, double t);

/// Output samples t_i = begin + i * output_step and kinks of the input, merged once, in indices: a kink that is
/// an output sample (within a billionth of a step) ends one stretch, and no stretch is a sliver: each is longer than
/// a billionth of an output step. Stretches join bit for bit and end on the kink where there is one. The last
/// sample is the last one that the input still covers; what remains after it is not run.
class Schedule {
 public:
  /// @throws std::invalid_argument unless output_step > 0 and the input lasts at least one output step and at
  ///         most kMostSamples of them
  Schedule(const Input& input, double output_step);

  [[nodiscard]] const std::vector<Stretch>& stretches() const { return stretches_; }
  [[nodiscard]] int samples() const { return samples_; }  // the one at the start included
  [[nodiscard]] double time(int sample) const { return begin_ + sample * output_step_; }
  [[nodiscard]] double outputStep() const { return output_step_; }

 private:
  double begin_;
  double output_step_;
  int samples_ = 0;
  std::vector<Stretch> stretches_;
};

/// Called at every output sample in order, sample 0 included. At a kink `segment` is the one that begins there
/// (right-hand limit). Returning false ends the run after this sample.
using Observer = std::function<bool(int sample, int segment, double t, std::span<const double> x)>;

/// What a run cost.
struct Statistics {
  long steps = 0;
  long evaluations = 0;  // of f(x, u); for `exact`: matrix exponentials
  long rejected = 0;     // steps repeated with a smaller size
  bool stopped = false;  // an observer ended it early
};

}  // namespace vehicle
