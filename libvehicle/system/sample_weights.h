#pragma once

#include <cstddef>
#include <vector>

#include "libvehicle/system/schedule.h"

namespace vehicle {

/// Weights that turn the samples of one smooth part of a run into an integral over it:
///
///     int y dt = sum_i w_i y(t_i),   i = 0 .. count, the begin of the part and the ends of its intervals
///
/// Exact for cubics. Equal intervals by Gregory's formula with three differences at either end; a shorter interval at an
/// end by the cubic through the four nearest samples; four samples or fewer by the polynomial through all of them.
/// Source: C. Jordan, Calculus of Finite Differences, ch. 7 (Gregory's formula).
class SampleWeights {
 public:
  /// @param intervals  of the schedule, count >= 1
  SampleWeights(const Schedule& schedule, const Schedule::Part& part);
  /// @param first, point_step, last  [s] > 0: lengths of the first, of all inner and of the last interval
  SampleWeights(std::size_t intervals, double first, double point_step, double last);

  /// @param sample  0 .. intervals   @return [s]
  [[nodiscard]] double operator[](std::size_t sample) const {
    if (sample < head_.size()) return head_[sample];
    const std::size_t from_end = intervals_ - sample;
    return from_end < tail_.size() ? tail_[from_end] : point_step_;
  }

 private:
  std::size_t intervals_;
  double point_step_;
  std::vector<double> head_;  // of the first samples; of all where they are few
  std::vector<double> tail_;  // of the last samples, counted from the end
};

}  // namespace vehicle
