#include "libvehicle/partition/schemes/halo_exchange.h"

#include <algorithm>

#include "libvehicle/partition/map/cut_order.h"
#include "libvehicle/partition/map/equation_map.h"
#include "libvehicle/partition/schemes/blocked_rk4.h"
#include "libvehicle/partition/schemes/exchange_plan.h"
#include "libvehicle/partition/schemes/own_state.h"
#include "libvehicle/partition/schemes/sample_ring.h"
#include "libvehicle/threads/exchange.h"

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// One thread's work: its steps and what it shows and takes.
class HaloMember {
 public:
  HaloMember(const CutRun& cut, const EquationGraph& graph, EquationRun target, const ExchangePlan::Part& part,
             Exchange& exchange)
      : exchange_(exchange), part_(part), rk4_(cut.set(), graph, cut.input(), target) {
    const EquationRun held = rk4_.held();
    std::copy_n(cut.x0().begin() + 2 * held.first, 2 * held.size(), rk4_.x());
    // The order in which the blocks of a step want them.
    for (const ExchangePlan::Source& source : part_.sources) {
      int block = rk4_.blocks();
      for (const ExchangePlan::Piece& piece : source.pieces)
        block = std::min(block, rk4_.firstBlockReading(piece.first));
      sources_.push_back({&source, std::min(block, rk4_.blocks() - 1)});
    }
    std::stable_sort(sources_.begin(), sources_.end(),
                     [](const Wanted& one, const Wanted& other) { return one.block < other.block; });
  }

  int stepsOfBlock() const { return rk4_.stepsOfBlock(); }
  void enter(const StepBlock& steps) { rk4_.enter(steps); }

  void move(Member& me, double h, int k) {
    me.beginStep(epoch_);
    rk4_.prepare(k);
    std::size_t taken = epoch_ == 0 ? sources_.size() : 0;  // the start is known to all
    rk4_.step(h, k, [&](int block) {
      for (; taken < sources_.size() && sources_[taken].block <= block; ++taken) take(me, *sources_[taken].source);
    });
    ++epoch_;
    if (!sources_.empty()) show(me);
    me.endStep(epoch_ - 1);
  }

  const double* x(int equation) { return rk4_.x(equation); }

 private:
  struct Wanted {
    const ExchangePlan::Source* source = nullptr;
    int block = 0;  // of the step: the first that reads it
  };

  void take(Member& me, const ExchangePlan::Source& source) {
    const double* shown = exchange_.await(me, source.owner, epoch_);
    for (const ExchangePlan::Piece& piece : source.pieces) {
      std::copy_n(shown + piece.slot, 2 * piece.count, rk4_.x(piece.first));
    }
  }

  void show(Member& me) {
    double* slot = exchange_.slot(me.number(), epoch_);
    for (const EquationRun& run : part_.shown) slot = std::copy_n(rk4_.x(run.first), 2 * run.size(), slot);
    exchange_.publish(me, epoch_);
  }

  Exchange& exchange_;
  const ExchangePlan::Part& part_;
  BlockedRk4 rk4_;
  std::vector<Wanted> sources_;
  long epoch_ = 0;  // steps done
};

}  // namespace

PartitionRun runHaloExchange(const RunProblem& problem, FixedStep step, const Observer& observe, const Sharing& sharing,
                             const TeamPolicy& team) {
  const CutRun cut(problem);
  const EquationGraph graph(cut.set());
  PartitionRun run;
  run.shares = shareEquations(cut.set(), sharing.map, sharing.threads);
  const ExchangePlan plan(run.shares, halosOf(graph, run.shares));
  Exchange exchange(plan.values);
  SampleRing ring("rk4", sharing.threads, cut.set().size(), observe);
  run.team = runTeam(sharing.threads, team, [&](Member& me) {
    if (me.number() == 0 && !ring.begin(me, problem)) return;
    const std::vector<int>& share = run.shares[at(me.number())];
    HaloMember work(cut, graph, hullOf(share), plan.parts[at(me.number())], exchange);
    const OwnState own(cut.set(), share);
    const bool whole = walkSteps(
        {problem.schedule, step, work.stepsOfBlock()}, [&](const StepBlock& steps) { work.enter(steps); },
        [&](double h, int k) { work.move(me, h, k); },
        [&](const StepPause& here) {
          return ring.show(me, here, [&](double* x) { return own.copyTo(x, [&](int e) { return work.x(e); }); });
        });
    if (whole && me.number() == 0) ring.finish(me);
  });
  run.statistics = ring.statistics();
  run.statistics.evaluations = 4 * run.statistics.steps;
  return run;
}

double haloExchangeStep(const StepCosts& costs, const EquationSet& set, const Sharing& sharing) {
  const EquationGraph graph(set);
  double busiest = 0.0;
  for (const std::vector<int>& share : shareEquations(set, sharing.map, sharing.threads)) {
    EquationRun run = hullOf(share);
    double work = 0.0;
    for (int stage = 0; stage < 4; ++stage, run = graph.reach(run)) work += run.size();
    busiest = std::max(busiest, work / (4.0 * graph.size()));
  }
  return costs.exchange + busiest * costs.step;
}

}  // namespace vehicle
