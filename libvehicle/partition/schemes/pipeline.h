#pragma once

#include <numeric>

#include "libvehicle/integrate/fixed_steps.h"
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
  Stepper stepper;
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
  BlockRows rows;  // the input at half steps; sweepRows() for the bits of FixedSteps
  int threads = 2;
};

/// A run of fixed steps whose input is computed ahead: member 0 steps, all members compute input blocks
/// (input_ahead.h). What is shared is the input alone: the bits of FixedSteps for every number of threads, and at
/// best (step + input) / threads, but never less than a step without its input.
///
/// @tparam Stepper  as for FixedSteps, in the order of the problem's input and x0; the system is not looked at
/// @throws as FixedSteps and runTeam()
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
    const auto feed = [&](const StepBlock& block) { return ahead.enter(me, block); };
    const auto steps = [&](const auto& by) {
      FixedSteps run(by, width, feed, shared.step);
      return run.run(problem.schedule, problem.x0, observe);
    };
    made.run.statistics = team.tracer == nullptr ? steps(stepper) : steps(TracedStepper<Stepper>{stepper, me});
    if (made.run.statistics.stopped) me.stopTeam();
  });
  made.run.shares.emplace_back(static_cast<std::size_t>(stepper.size() / 2));
  std::iota(made.run.shares.front().begin(), made.run.shares.front().end(), 0);
  made.input = ahead.counts();
  return made;
}

/// Rows by Input::sweep, as FixedSteps asks for them. Looks at the input.
[[nodiscard]] BlockRows sweepRows(const Input& input);

/// makeRk4() of any System with its input computed ahead.
/// @throws as makeRk4() and runTeam()
PipelineRun runPipeline(const RunProblem& problem, FixedStep step, const Observer& observe, int threads,
                        const TeamPolicy& team);

/// [s] a step takes at best.
[[nodiscard]] double pipelineStep(const StepCosts& costs, int threads);

}  // namespace vehicle
