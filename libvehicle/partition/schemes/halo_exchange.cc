#include "libvehicle/partition/schemes/halo_exchange.h"

#include <algorithm>

#include "libvehicle/partition/map/cut_order.h"
#include "libvehicle/partition/map/equation_map.h"
#include "libvehicle/partition/schemes/blocked_rk4.h"
#include "libvehicle/partition/schemes/own_state.h"
#include "libvehicle/partition/schemes/sample_ring.h"
#include "libvehicle/partition/schemes/shown_piece.h"
#include "libvehicle/threads/exchange.h"

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// What each thread shows and what it takes from whom; made once, before the team starts.
class HaloPlan {
 public:
  struct Source {
    int owner = 0;
    int block = 0;  // of the reader's step: the first that reads it
    std::vector<ShownPiece> pieces;
  };
  struct Part {
    EquationRun target;
    std::vector<EquationRun> shown;  // own equations that others hold, in the order of the slot
    std::vector<Source> sources;     // by owner; a thread that only reads from us is one without pieces
  };

  HaloPlan(const EquationGraph& graph, const std::vector<std::vector<int>>& shares) {
    const std::vector<int> owner = ownersOf(shares, graph.size());
    const int threads = static_cast<int>(shares.size());
    std::vector<EquationRun> held;
    for (const std::vector<int>& share : shares) {
      parts_.push_back({.target = hullOf(share), .shown = {}, .sources = {}});
      EquationRun reach = parts_.back().target;
      for (int stage = 0; stage < 4; ++stage) reach = graph.reach(reach);
      held.push_back(reach);
    }
    // place[e]: of equation e in its owner's slot, or -1.
    std::vector<int> place(at(graph.size()), -1);
    values_.assign(at(threads), 0);
    for (int thread = 0; thread < threads; ++thread) {
      std::vector<int> shown;
      for (const int e : shares[at(thread)]) {
        const bool wanted = std::any_of(held.begin(), held.end(), [&](const EquationRun& run) {
          return &run != &held[at(thread)] && run.holds(e);
        });
        if (!wanted) continue;
        place[at(e)] = values_[at(thread)];
        values_[at(thread)] += 2;
        shown.push_back(e);
      }
      parts_[at(thread)].shown = runsOf(shown);
    }
    std::vector<std::vector<char>> reads(at(threads), std::vector<char>(at(threads), 0));
    for (int thread = 0; thread < threads; ++thread) {
      for (int e = held[at(thread)].first; e < held[at(thread)].last; ++e) reads[at(thread)][at(owner[at(e)])] = 1;
    }
    for (int thread = 0; thread < threads; ++thread) {
      for (int other = 0; other < threads; ++other) {
        if (other == thread || !(reads[at(thread)][at(other)] || reads[at(other)][at(thread)])) continue;
        Source source{.owner = other, .block = 0, .pieces = {}};
        for (int e = held[at(thread)].first; e < held[at(thread)].last; ++e) {
          if (owner[at(e)] == other) addShown(source.pieces, place[at(e)], e);
        }
        parts_[at(thread)].sources.push_back(std::move(source));
      }
    }
  }

  [[nodiscard]] const Part& part(int thread) const { return parts_[at(thread)]; }
  [[nodiscard]] const std::vector<int>& values() const { return values_; }

 private:
  std::vector<Part> parts_;
  std::vector<int> values_;
};

// One thread's work: its steps and what it shows and takes.
class HaloMember {
 public:
  HaloMember(const CutRun& cut, const EquationGraph& graph, const HaloPlan& plan, Exchange& exchange, Member& me)
      : me_(me), exchange_(exchange), part_(plan.part(me.number())), rk4_(cut.set(), graph, cut.input(), part_.target) {
    const EquationRun held = rk4_.held();
    std::copy_n(cut.x0().begin() + 2 * held.first, 2 * held.size(), rk4_.x());
    // The order in which the blocks of a step want them.
    for (const HaloPlan::Source& source : part_.sources) {
      int block = rk4_.blocks();
      for (const ShownPiece& piece : source.pieces) block = std::min(block, rk4_.firstBlockReading(piece.first));
      sources_.push_back(source);
      sources_.back().block = std::min(block, rk4_.blocks() - 1);
    }
    std::stable_sort(sources_.begin(), sources_.end(),
                     [](const auto& one, const auto& other) { return one.block < other.block; });
  }

  int stepsOfBlock() const { return rk4_.stepsOfBlock(); }
  void enter(const StepBlock& steps) { rk4_.enter(steps); }

  void move(double h, int k) {
    me_.beginStep(epoch_);
    rk4_.prepare(k);
    std::size_t taken = epoch_ == 0 ? sources_.size() : 0;  // the start is known to all
    rk4_.step(h, k, [&](int block) {
      for (; taken < sources_.size() && sources_[taken].block <= block; ++taken) take(sources_[taken]);
    });
    ++epoch_;
    if (!sources_.empty()) show();
    me_.endStep(epoch_ - 1);
  }

  const double* x(int equation) { return rk4_.x(equation); }

 private:
  void take(const HaloPlan::Source& source) {
    const double* shown = exchange_.await(me_, source.owner, epoch_);
    for (const ShownPiece& piece : source.pieces) {
      std::copy_n(shown + piece.slot, 2 * piece.count, rk4_.x(piece.first));
    }
  }

  void show() {
    double* slot = exchange_.slot(me_.number(), epoch_);
    for (const EquationRun& run : part_.shown) slot = std::copy_n(rk4_.x(run.first), 2 * run.size(), slot);
    exchange_.publish(me_, epoch_);
  }

  Member& me_;
  Exchange& exchange_;
  const HaloPlan::Part& part_;
  BlockedRk4 rk4_;
  std::vector<HaloPlan::Source> sources_;
  long epoch_ = 0;  // steps done
};

}  // namespace

PartitionRun runHaloExchange(const System& system, const Input& input, const Schedule& schedule, FixedStep step,
                             std::span<const double> x0, const Observer& observe, const PartitionChoice& choice) {
  const CutRun cut(system, input, x0);
  const EquationGraph graph(cut.set());
  PartitionRun run;
  run.shares = shareEquations(cut.set(), choice.map, choice.team.threads);
  const HaloPlan plan(graph, run.shares);
  Exchange exchange(plan.values());
  SampleRing ring("rk4", choice.team.threads, cut.set().size(), observe);
  const Stretch start = schedule.stretches().front();
  run.team = runTeam(choice.team, [&](Member& me) {
    if (me.number() == 0 && !ring.begin(me, start.segment, start.begin, x0)) return;
    HaloMember work(cut, graph, plan, exchange, me);
    const OwnState own(cut.set(), run.shares[at(me.number())]);
    const bool whole = walkSteps(
        schedule, step, work.stepsOfBlock(), [&](const StepBlock& steps) { work.enter(steps); },
        [&](double h, int k) { work.move(h, k); },
        [&](const StepPause& here) {
          return ring.show(me, here, [&](double* x) { return own.copyTo(x, [&](int e) { return work.x(e); }); });
        });
    if (whole && me.number() == 0) ring.finish(me);
  });
  run.statistics = ring.statistics();
  run.statistics.evaluations = 4 * run.statistics.steps;
  return run;
}

}  // namespace vehicle
