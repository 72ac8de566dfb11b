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

/// What of a run is shared: the rows that its steps read.
struct Pipeline {
  FixedStep step;
  BlockRows rows;  // the input at half steps; sweepRows() for the bits of runFixedStep()
  int threads = 2;
};

/// A run of fixed steps whose input is computed ahead: member 0 steps, all members compute input blocks
/// (input_ahead.h). What is shared is the input alone: the bits of runFixedStep() for every number of threads, and at
/// best (step + input) / threads, but never less than a step without its input.
///
/// @tparam Stepper  as for runFixedStep(), in the order of the problem's input and x0; the system is not looked at
/// @throws as runFixedStep() and runTeam()
template <class Stepper>
PipelineRun runPipelined(const Stepper& stepper, const RunProblem& problem, const Pipeline& shared,
                         const Observer& observe, const TeamPolicy& team) {
  const int width = 2 * problem.input.channels();
  InputAhead ahead(problem.schedule, shared.step, width, shared.rows);
  PipelineRun made;
  made.run.team = runTeam(shared.threads, team, [&](Member& me) {
    if (me.number() > 0) {
      ahead.help(me);
      return;
    }
    const auto feed = [&](int segment, double begin, double h, int first, int last) {
      return ahead.enter(me, {segment, begin, h, first, last});
    };
    const auto steps = [&](auto& own) {
      return runFedSteps(own, width, feed, problem.schedule, shared.step, problem.x0, observe);
    };
    // A copy of its own: what the compiler knows to be this thread's alone it keeps in registers.
    Stepper own(stepper);
    if (team.tracer == nullptr) {
      made.run.statistics = steps(own);
    } else {
      TracedStepper<Stepper> traced{own, me};
      made.run.statistics = steps(traced);
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

/// runRk4() of any System with its input computed ahead.
/// @throws as runRk4() and runTeam()
PipelineRun runPipeline(const RunProblem& problem, FixedStep step, const Observer& observe, int threads,
                        const TeamPolicy& team);

/// [s] a step takes at best.
[[nodiscard]] double pipelineStep(const StepCosts& costs, int threads);

}  // namespace vehicle
