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
};

/// Output samples t_i = begin + i * output_step and kinks of the input, merged once, in indices: a kink that is
/// an output sample ends one stretch, and no stretch is a sliver.
class Schedule {
 public:
  /// @throws std::invalid_argument unless output_step > 0 and the input lasts at least one output step
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
