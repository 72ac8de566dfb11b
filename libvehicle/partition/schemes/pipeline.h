#pragma once

#include <numeric>

#include "libvehicle/integrate/failure.h"
#include "libvehicle/partition/run.h"
#include "libvehicle/partition/schemes/input_ahead.h"

namespace vehicle {

/// Statistics of a pipelined run, and who computed its input.
struct PipelineRun {
  PartitionRun run;
  AheadCounts input;
};

/// A stepper whose every step is framed for the trace.
template <class Stepper>
struct TracedStepper {
  static constexpr const char* kName = Stepper::kName;
  static constexpr int kEvaluations = Stepper::kEvaluations;
  Stepper& stepper;
  Member& me;
  long number = 0;

  [[nodiscard]] int size() const { return stepper.size(); }
  void step(double h, const double* u_begin, const double* u_middle, const double* u_end, double* x) {
    me.beginStep(number);
    stepper.step(h, u_begin, u_middle, u_end, x);
    me.endStep(number++);
  }
};

/// A run of fixed steps whose input is computed ahead: member 0 steps, all members compute input blocks
/// (input_ahead.h). What is shared is the input alone: the bits of runFixedStep() for every number of threads, and at
/// best (step + input) / threads, but never less than a step without its input.
///
/// @tparam Stepper  as for runFixedStep()
/// @param rows      the input at half steps; sweepRows() for the bits of runFixedStep()
/// @throws as runFixedStep() and runTeam()
template <class Stepper>
PipelineRun runPipelined(const Stepper& stepper, int channels, const BlockRows& rows, const Schedule& schedule,
                         FixedStep step, std::span<const double> x0, const Observer& observe, const TeamChoice& team) {
  const int width = 2 * channels;
  InputAhead ahead(schedule, step, width, rows);
  PipelineRun made;
  made.run.team = runTeam(team, [&](Member& me) {
    if (me.number() > 0) {
      ahead.help(me);
      return;
    }
    const auto feed = [&](int segment, double begin, double h, int first, int last) {
      return ahead.enter(me, {segment, begin, h, first, last});
    };
    // A copy of its own: what the compiler knows to be this thread's alone it keeps in registers.
    Stepper own(stepper);
    if (team.tracer == nullptr) {
      made.run.statistics = runFedSteps(own, width, feed, schedule, step, x0, observe);
    } else {
      TracedStepper<Stepper> traced{own, me};
      made.run.statistics = runFedSteps(traced, width, feed, schedule, step, x0, observe);
    }
    if (made.run.statistics.stopped) me.stopTeam();
  });
  made.run.shares.emplace_back(static_cast<std::size_t>(stepper.size() / 2));
  std::iota(made.run.shares.front().begin(), made.run.shares.front().end(), 0);
  made.input = ahead.counts();
  return made;
}

/// Rows by Input::sweep, as runFixedStep() asks for them. Looks at the input.
[[nodiscard]] BlockRows sweepRows(const Input& input);

/// Rows by the formula at every half step, one sine and cosine per frequency each: what the rail costs where nobody
/// has thought about it. For measurements; differs from sweepRows() by Input::sweepError(). Looks at the input.
[[nodiscard]] BlockRows evaluatedRows(const Input& input);

/// runRk4() of any System with its input computed ahead.
/// @throws as runRk4() and runTeam()
PipelineRun runPipeline(const System& system, const Input& input, const Schedule& schedule, FixedStep step,
                        std::span<const double> x0, const Observer& observe, const TeamChoice& team);

}  // namespace vehicle
