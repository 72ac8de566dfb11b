#pragma once

#include <algorithm>

#include "libvehicle/system/schedule.h"

namespace vehicle {

/// Size of fixed steps: the largest that is not above `step` and divides an interval evenly, then cut `refine`
/// times. Doubling refine doubles the steps of every interval, which is what a convergence order is read from.
struct FixedStep {
  double step = 1e-3;  // [s] > 0
  int refine = 1;      // >= 1
};

/// Number of equal steps of an interval: the fewest that are not above step.step, then each cut in step.refine.
/// A length that exceeds a multiple of the step by rounding alone does not cost one more.
/// @param length  [s] > 0
/// @throws std::invalid_argument unless step.step > 0 and finite, step.refine >= 1, and the number is below 1e9
[[nodiscard]] int stepsOf(double length, FixedStep step);

/// Neighbouring intervals, run as one grid of equal steps.
struct StepGrid {
  int segment = 0;     // of the input
  double begin = 0.0;  // [s]
  double h = 0.0;      // [s]
  int steps = 0;       // of each interval
  int count = 1;       // intervals

  [[nodiscard]] int total() const { return steps * count; }
};

/// The longest grid that begins with that interval. Whole output steps in one segment of the input share a grid: the
/// sine and cosine that seed the input are then paid once a block and not once a sample.
[[nodiscard]] StepGrid stepGridFrom(const Interval& interval, FixedStep step);

/// Steps that are fed with one block of input. A multiple of Input::kBlock / 2, so that blocks begin where the
/// input is seeded anew and the cut leaves no trace in the numbers.
inline constexpr int kStepsPerBlock = 2 * Input::kBlock;

/// Steps first .. last-1 of a grid that begins at `begin`; their input is prepared as one.
struct StepBlock {
  int segment = 0;     // of the input
  double begin = 0.0;  // [s] of the grid
  double h = 0.0;      // [s]
  int first = 0;       // a multiple of Input::kBlock / 2
  int last = 0;

  /// Rows of the input at its half steps: t, t + h/2, t + h of the first step, and two more for each further one.
  [[nodiscard]] int rows() const { return 2 * (last - first) + 1; }
  /// All of them by Input::sweep().
  /// @param u  (rows() x 2 channels)
  void sweep(const Input& input, std::span<double> u) const {
    input.sweep(segment, begin, 0.5 * h, 2 * first, rows(), u);
  }
  /// The phases from which Input::readRow() makes them one by one: step k reads the samples 2 k, 2 k + 1, 2 k + 2.
  void prepare(const Input& input, PhasorTable& phases) const {
    input.prepare(segment, begin, 0.5 * h, 2 * first, rows(), phases);
  }
};

/// Where fixed steps stand in a run: the grid that the interval belongs to, and the block of it that is in hand.
class StepCursor {
 public:
  /// @param block  steps whose input is prepared at a time: kStepsPerBlock or a part of it that is a multiple of
  ///               Input::kBlock / 2
  explicit StepCursor(FixedStep step, int block = kStepsPerBlock) : step_(step), block_(block) {}

  /// The next interval begins a grid of its own.
  void restart() { done_ = block_end_ = grid_.steps = 0; }

  /// All steps of the next interval.
  /// @param enter  enter(const StepBlock&) before the first step of a block
  /// @param move   move(double h, int k): step k of the block, 0 <= k < last - first
  /// @param check  check(double reached) after every kStepsPerBlock steps of the grid that do not end the interval;
  ///               false ends the walk. reached [s] is the time by the steps of the grid
  /// @return  false if a check ended it
  /// @throws std::invalid_argument for a wrong step (stepsOf)
  template <class Enter, class Move, class Check>
  bool advance(const Interval& interval, Enter enter, Move move, Check check) {
    if (done_ == grid_.total()) {
      grid_ = stepGridFrom(interval, step_);
      done_ = block_end_ = 0;
    }
    for (int left = grid_.steps; left > 0;) {
      if (done_ == block_end_) {
        first_ = done_;
        block_end_ = std::min(done_ + block_, grid_.total());
        enter(StepBlock{grid_.segment, grid_.begin, grid_.h, first_, block_end_});
      }
      const double h = grid_.h;
      const int begin = done_ - first_;
      const int end = std::min(block_end_ - first_, begin + left);
      for (int k = begin; k < end; ++k) move(h, k);
      done_ += end - begin;
      left -= end - begin;
      steps_ += end - begin;
      if (left > 0 && done_ % kStepsPerBlock == 0 && !check(reached())) return false;
    }
    return true;
  }

  [[nodiscard]] double reached() const { return grid_.begin + done_ * grid_.h; }  // [s] by the steps of the grid
  [[nodiscard]] long steps() const { return steps_; }                             // since the cursor was made

 private:
  FixedStep step_;
  int block_;
  StepGrid grid_;
  int first_ = 0;      // of the block in hand
  int block_end_ = 0;  // behind it
  int done_ = 0;       // of the grid
  long steps_ = 0;
};

/// Where a run looks at its state: at the ends of intervals and of every kStepsPerBlock steps of a grid.
struct StepPause {
  double reached = 0.0;  // [s] by the steps of the grid, named where the state is no longer finite
  int sample = -1;       // number of the output sample here, or -1
  int segment = 0;       // that begins here, where there is a sample
  double end = 0.0;      // [s] of the interval, where there is a sample
  long steps = 0;        // done since the run began
};

/// The way through a run.
struct StepWalk {
  const Schedule& schedule;
  FixedStep step;
  int block = kStepsPerBlock;  // StepCursor's
};

/// Leads a thread through all steps of a run: the grids, pauses and samples of FixedSteps, so that every thread
/// of a team walks the same way without a word between them.
///
/// @param enter, move  as StepCursor::advance() calls them
/// @param pause        pause(const StepPause&): false ends the walk
/// @return  false if a pause ended it
/// @throws std::invalid_argument for a wrong step (stepsOf)
template <class Enter, class Move, class Pause>
bool walkSteps(const StepWalk& way, Enter enter, Move move, Pause pause) {
  StepCursor cursor(way.step, way.block);
  for (const Interval interval : way.schedule.intervals()) {
    const auto check = [&](double reached) { return pause(StepPause{.reached = reached, .steps = cursor.steps()}); };
    if (!cursor.advance(interval, enter, move, check)) return false;
    if (!pause({cursor.reached(), interval.sample, interval.next, interval.end, cursor.steps()})) return false;
  }
  return true;
}

}  // namespace vehicle
