#pragma once

#include <algorithm>

#include "libvehicle/integrate/fixed_step_run.h"

namespace vehicle {

/// Steps first .. last-1 of a grid that begins at `begin`; their input is wound as one.
struct StepBlock {
  int segment = 0;     // of the input
  double begin = 0.0;  // [s] of the grid
  double h = 0.0;      // [s]
  int first = 0;       // a multiple of Input::kBlock / 2
  int last = 0;

  /// The clock of the rows t, t + h/2, t + h of its steps: step k reads the samples 2 k, 2 k + 1, 2 k + 2.
  void prepare(const Input& input, PhasorTable& clock) const {
    input.prepare(segment, begin, 0.5 * h, 2 * first, 2 * (last - first) + 1, clock);
  }
};

/// Where a run looks at its state: at the ends of intervals and of every kStepsPerBlock steps of a grid.
struct StepPause {
  double reached = 0.0;  // [s] by the clock of the grid, named where the state is no longer finite
  int sample = -1;       // number of the output sample here, or -1
  int segment = 0;       // that begins here, where there is a sample
  double end = 0.0;      // [s] of the interval, where there is a sample
  long steps = 0;        // done since the run began
};

/// The way through a run.
struct StepWalk {
  const Schedule& schedule;
  FixedStep step;
  int block = kStepsPerBlock;  // steps wound at a time: kStepsPerBlock or a part of it that is a multiple of
                               // Input::kBlock / 2
};

/// Leads a thread through all steps of a run: the grids, pauses and samples of runFixedStep(), so that every thread
/// of a team walks the same way without a word between them.
///
/// @param enter  enter(const StepBlock&) before the first step of a block
/// @param move   move(double h, int k): step k of the block, 0 <= k < last - first
/// @param pause  pause(const StepPause&): false ends the walk
/// @return  false if a pause ended it
/// @throws std::invalid_argument for a wrong step (stepsOf)
template <class Enter, class Move, class Pause>
bool walkSteps(const StepWalk& way, Enter enter, Move move, Pause pause) {
  const Schedule::Intervals intervals = way.schedule.intervals();
  auto next = intervals.begin();
  long steps = 0;
  for (std::size_t first = 0; first < intervals.size();) {
    const StepGrid grid = stepGridAt(way.schedule, first, way.step);
    Interval interval = *next;
    const double begin = interval.begin;
    const int total = grid.steps * static_cast<int>(grid.count);
    int left = grid.steps;  // of this interval
    for (int done = 0; done < total;) {
      const StepBlock now{interval.segment, begin, grid.h, done, std::min(done + way.block, total)};
      enter(now);
      while (done < now.last) {
        const int stop = std::min(now.last, done + left);
        steps += stop - done;
        left -= stop - done;
        for (; done < stop; ++done) move(grid.h, done - now.first);
        if (left > 0 && done % kStepsPerBlock != 0) continue;
        StepPause here{.reached = begin + done * grid.h, .steps = steps};
        if (left == 0) {
          here.sample = interval.sample;
          here.segment = interval.next;
          here.end = interval.end;
          ++next;
          if (done < total) interval = *next;
          left = grid.steps;
        }
        if (!pause(here)) return false;
      }
    }
    first += grid.count;
  }
  return true;
}

}  // namespace vehicle
