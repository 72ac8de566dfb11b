#include "libvehicle/partition/schemes/stage_exchange.h"

#include <algorithm>
#include <optional>

#include "libvehicle/integrate/rk4_stages.h"
#include "libvehicle/partition/map/cut_order.h"
#include "libvehicle/partition/map/equation_map.h"
#include "libvehicle/partition/schemes/exchange_plan.h"
#include "libvehicle/partition/schemes/own_state.h"
#include "libvehicle/partition/schemes/sample_ring.h"
#include "libvehicle/partition/schemes/stage_rows.h"
#include "libvehicle/threads/exchange.h"

namespace vehicle {
namespace {

/// The smallest run that holds the equations of a share and their neighbours.
EquationRun heldBy(const EquationGraph& graph, const std::vector<int>& share) {
  EquationRun held = hullOf(share);
  for (const int e : share) {
    held.first = std::min(held.first, graph.lowest(e));
    held.last = std::max(held.last, graph.highest(e) + 1);
  }
  return held;
}

/// The smallest run of channels that enter the equations of a share.
ChannelRun channelsOf(const EquationGraph& graph, const std::vector<int>& share) {
  ChannelRun all{};
  for (const EquationRun& run : runsOf(share)) {
    const ChannelRun more = graph.channels(run);
    if (more.size() == 0) continue;
    all = all.size() == 0 ? more : ChannelRun{std::min(all.first, more.first), std::max(all.last, more.last)};
  }
  return all;
}

// One thread's equations. Its arrays hold the interval of the state between the lowest and the highest equation that
// it computes or reads; entries in between that are neither stay zero.
class StageMember {
 public:
  StageMember(const CutRun& cut, const std::vector<int>& share, EquationRun held, const ExchangePlan::Part& part,
              Exchange& exchange)
      : set_(cut.set()),
        exchange_(exchange),
        part_(part),
        own_(runsOf(share)),
        held_(held),
        x_(static_cast<std::size_t>(2 * held.size())),
        stage_(x_.size()),
        slope_(x_.size()),
        sum_(x_.size()) {
    std::copy_n(cut.x0().begin() + 2 * held.first, x_.size(), x_.begin());
  }

  template <class Rows>
  void step(Member& me, double h, Rows& rows) {
    me.beginStep(epoch_ / 4);
    if (epoch_ > 0) take(me, x_);  // the start is known to all
    evaluate(x_, rows.row(0), rows.channels());
    forOwn([&](std::size_t i, int n) { afterFirstStage(h, &x_[i], &slope_[i], &sum_[i], &stage_[i], n); });
    show(me, stage_);
    rows.afterStage(0);
    take(me, stage_);
    evaluate(stage_, rows.row(1), rows.channels());
    forOwn([&](std::size_t i, int n) { afterMiddleStage<1>(h, &x_[i], &slope_[i], &sum_[i], &stage_[i], n); });
    show(me, stage_);
    rows.afterStage(1);
    take(me, stage_);
    evaluate(stage_, rows.row(1), rows.channels());
    forOwn([&](std::size_t i, int n) { afterMiddleStage<2>(h, &x_[i], &slope_[i], &sum_[i], &stage_[i], n); });
    show(me, stage_);
    rows.afterStage(2);
    take(me, stage_);
    evaluate(stage_, rows.row(2), rows.channels());
    forOwn([&](std::size_t i, int n) { afterLastStage(h, &slope_[i], &sum_[i], &x_[i], n); });
    show(me, x_);
    rows.afterStage(3);
    me.endStep(epoch_ / 4 - 1);
  }

  const double* x(int equation) const { return &x_[place(equation)]; }

 private:
  std::size_t place(int equation) const { return static_cast<std::size_t>(2 * (equation - held_.first)); }

  template <class Update>
  void forOwn(Update update) {
    for (const EquationRun& run : own_) update(place(run.first), 2 * run.size());
  }

  void evaluate(const std::vector<double>& x, const double* u, ChannelRun channels) {
    for (const EquationRun& run : own_) {
      set_.derivative({.first = run.first,
                       .last = run.last,
                       .x = x.data(),
                       .x_first = held_.first,
                       .u = u,
                       .u_first = channels.first,
                       .u_count = channels.size(),
                       .dx = slope_.data(),
                       .dx_first = held_.first});
    }
  }

  void show(Member& me, const std::vector<double>& values) {
    ++epoch_;
    if (part_.sources.empty()) return;
    double* slot = exchange_.slot(me.number(), epoch_);
    for (const EquationRun& run : part_.shown) {
      const double* from = &values[place(run.first)];
      for (int i = 0; i < 2 * run.size(); ++i) *slot++ = from[i];
    }
    exchange_.publish(me, epoch_);
  }

  void take(Member& me, std::vector<double>& values) {
    for (const ExchangePlan::Source& source : part_.sources) {
      const double* shown = exchange_.await(me, source.owner, epoch_);
      for (const ExchangePlan::Piece& piece : source.pieces) {
        double* to = &values[place(piece.first)];
        for (int i = 0; i < 2 * piece.count; ++i) to[i] = shown[piece.slot + i];
      }
    }
  }

  const EquationSet& set_;
  Exchange& exchange_;
  const ExchangePlan::Part& part_;
  std::vector<EquationRun> own_;
  EquationRun held_;
  std::vector<double> x_, stage_, slope_, sum_;
  long epoch_ = 0;  // stages done
};

}  // namespace

PartitionRun runStageExchange(const RunProblem& problem, FixedStep step, const Observer& observe,
                              const Sharing& sharing, const TeamPolicy& team) {
  const CutRun cut(problem);
  const EquationGraph graph(cut.set());
  PartitionRun run;
  run.shares = shareEquations(cut.set(), sharing.map, sharing.threads);
  const ExchangePlan plan(run.shares, neighboursOf(graph, run.shares));
  Exchange exchange(plan.values);
  SampleRing ring("rk4", sharing.threads, cut.set().size(), observe);

  // Alone, nobody's values are on their way: whole blocks are swept sooner than rows.
  const StepWalk way{problem.schedule, step, SweptRows::kSteps};
  const bool alone = sharing.threads == 1;
  const bool shares_rail = sharing.map == EquationMap::kPaper || (alone && isSwept(cut.input()));
  std::vector<SweptRows> shared(shares_rail ? 2 : 0, SweptRows(cut.input()));
  std::optional<BlocksAhead> ahead;
  if (shares_rail) {
    ahead.emplace(way);
    SharedRows::sweep(shared, *ahead, 0);
  }
  run.team = runTeam(sharing.threads, team, [&](Member& me) {
    if (me.number() == 0 && !ring.begin(me, problem)) return;
    const auto number = static_cast<std::size_t>(me.number());
    const std::vector<int>& share = run.shares[number];
    const OwnState own(cut.set(), share);
    StageMember work(cut, share, heldBy(graph, share), plan.parts[number], exchange);
    const auto along = [&](auto rows) {
      return walkSteps(
          way, [&](const StepBlock& steps) { rows.enter(steps); },
          [&](double h, int k) {
            rows.beginStep(k);
            work.step(me, h, rows);
          },
          [&](const StepPause& here) {
            return ring.show(me, here, [&](double* x) { return own.copyTo(x, [&](int e) { return work.x(e); }); });
          });
    };
    const bool sweeps = alone || me.number() == kRailThread;
    const bool whole = shares_rail ? along(SharedRows(shared, {0, cut.set().channels()}, sweeps ? &*ahead : nullptr))
                                   : along(AheadRows(cut.input(), channelsOf(graph, share), way));
    if (whole && me.number() == 0) ring.finish(me);
  });
  run.statistics = ring.statistics();
  run.statistics.evaluations = 4 * run.statistics.steps;
  return run;
}

double stageExchangeStep(const StepCosts& costs, const EquationSet& set, const Sharing& sharing) {
  std::size_t busiest = 0;
  for (const auto& share : shareEquations(set, sharing.map, sharing.threads)) busiest = std::max(busiest, share.size());
  return 4.0 * costs.exchange + costs.step * static_cast<double>(busiest) / static_cast<double>(set.equations().size());
}

}  // namespace vehicle
