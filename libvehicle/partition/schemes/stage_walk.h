#pragma once

#include <optional>
#include <span>
#include <vector>

#include "libvehicle/partition/map/cut_order.h"
#include "libvehicle/partition/map/equation_map.h"
#include "libvehicle/partition/run.h"
#include "libvehicle/partition/schemes/own_state.h"
#include "libvehicle/partition/schemes/sample_ring.h"
#include "libvehicle/partition/schemes/stage_plan.h"
#include "libvehicle/partition/schemes/stage_rows.h"
#include "libvehicle/threads/exchange.h"

namespace vehicle {

/// What a member of a stage exchange works with.
struct StageSeat {
  const CutRun& cut;
  const StagePlan::Part& part;
  Exchange& exchange;
  Member& me;
};

/// A whole run by stage exchange, whatever computes a thread's equations.
///
/// @param whole_rows  true: rows have all channels of the input, or none
/// @param sit         sit(seat, walk): makes the seat's work and returns walk(work), where
///                    work.step(h, rows) makes a step: show stage s, rows.afterStage(s), await the others, s = 0 .. 3;
///                    work.x(e) points at (q, q') of an own equation, those of a contiguous run in a row
template <class Sit>
PartitionRun runStages(const System& system, const Input& input, const Schedule& schedule, FixedStep step,
                       std::span<const double> x0, const Observer& observe, const PartitionChoice& choice,
                       bool whole_rows, Sit sit) {
  const CutRun cut(system, input, x0);
  const EquationGraph graph(cut.set());
  PartitionRun run;
  run.shares = shareEquations(cut.set(), choice.map, choice.team.threads);
  const StagePlan plan(graph, run.shares);
  Exchange exchange(plan.values);
  SampleRing ring("rk4", choice.team.threads, cut.set().size(), observe);
  const Stretch start = schedule.stretches().front();
  const ChannelRun all{0, cut.set().channels()};

  // Alone, nobody's values are on their way: whole blocks are swept sooner than rows.
  const bool alone = choice.team.threads == 1;
  const bool shares_rail = choice.map == EquationMap::kPaper || (alone && isSwept(cut.input()));
  std::vector<SweptRows> shared(shares_rail ? 2 : 0, SweptRows(cut.input()));
  std::optional<BlocksAhead> ahead;
  if (shares_rail) {
    ahead.emplace(schedule, step);
    SharedRows::sweep(shared, *ahead, 0);
  }
  run.team = runTeam(choice.team, [&](Member& me) {
    if (me.number() == 0 && !ring.begin(me, start.segment, start.begin, x0)) return;
    const StagePlan::Part& part = plan.parts[static_cast<std::size_t>(me.number())];
    const OwnState own(cut.set(), part.share);
    const auto walk = [&](auto& work) {
      const auto show = [&](const StepPause& here) {
        return ring.show(me, here, [&](double* x) { return own.copyTo(x, [&](int e) { return work.x(e); }); });
      };
      const auto along = [&](auto rows) {
        return walkSteps(
            schedule, step, SweptRows::kSteps, [&](const StepBlock& steps) { rows.enter(steps); },
            [&](double h, int k) {
              rows.beginStep(k);
              work.step(h, rows);
            },
            show);
      };
      if (shares_rail) return along(SharedRows(shared, all, alone || me.number() == kRailThread ? &*ahead : nullptr));
      const bool any = part.channels.size() > 0;
      return along(AheadRows(cut.input(), whole_rows && any ? all : part.channels, schedule, step));
    };
    const bool whole = sit(StageSeat{cut, part, exchange, me}, walk);
    if (whole && me.number() == 0) ring.finish(me);
  });
  run.statistics = ring.statistics();
  run.statistics.evaluations = 4 * run.statistics.steps;
  return run;
}

}  // namespace vehicle
