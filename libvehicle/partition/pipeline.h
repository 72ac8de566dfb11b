#pragma once

#include <numeric>

#include "libvehicle/integrate/failure.h"
#include "libvehicle/partition/input_ahead.h"
#include "libvehicle/partition/run.h"

namespace vehicle {

/// Statistics of a pipelined run, and who computed its input.
struct PipelineRun {
  PartitionRun run;
  AheadCounts input;
};

/// A run of fixed steps whose input is computed ahead: member 0 steps, all members compute input blocks
/// (input_ahead.h). What is shared is the input alone: the bits of runFixedStep() for every number of threads, and at
/// best (step + input) / threads, but never less than a step without its input.
///
/// @tparam Stepper  as for runFixedStep()
/// @param rows      the input at half steps; sweepRows() for the bits of runFixedStep()
/// @throws as runFixedStep() and runTeam()
template <class Stepper>
PipelineRun runPipelined(Stepper& stepper, int channels, const BlockRows& rows, const Schedule& schedule,
                         FixedStep step, std::span<const double> x0, const Observer& observe, const TeamChoice& team) {
  checkStart(Stepper::kName, x0, stepper.size());
  const int width = 2 * channels;
  InputAhead ahead(schedule, step, width, rows);
  PipelineRun made;
  Statistics& statistics = made.run.statistics;
  made.run.team = runTeam(team, [&](Member& me) {
    if (me.number() > 0) {
      ahead.help(me);
      return;
    }
    std::vector<double> x(x0.begin(), x0.end());
    const Stretch& start = schedule.stretches().front();
    statistics.stopped = !observe(0, start.segment, start.begin, x);
    const double* row = nullptr;
    long number = 0;
    statistics.stopped =
        statistics.stopped ||
        !walkSteps(
            schedule, step, kStepsPerBlock, [&](const StepBlock& block) { row = ahead.enter(me, block); },
            [&](double h, int) {
              me.beginStep(number);
              stepper.step(h, row, row + width, row + 2 * width, x.data());
              row += 2 * width;
              me.endStep(number++);
            },
            [&](const StepPause& here) {
              statistics.steps = here.steps;
              requireFinite(Stepper::kName, here.reached, x);
              return here.sample < 0 || observe(here.sample, here.segment, here.end, x);
            });
    if (statistics.stopped) me.stopTeam();
  });
  statistics.evaluations = Stepper::kEvaluations * statistics.steps;
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
