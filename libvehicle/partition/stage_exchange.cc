#include "libvehicle/partition/stage_exchange.h"

#include <algorithm>
#include <optional>

#include "libvehicle/partition/cut_order.h"
#include "libvehicle/partition/equation_map.h"
#include "libvehicle/partition/exchange.h"
#include "libvehicle/partition/own_state.h"
#include "libvehicle/partition/rail_rows.h"
#include "libvehicle/partition/rk4_stages.h"
#include "libvehicle/partition/sample_ring.h"

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// Who shows what to whom. A thread shows the equations that are neighbours of another's, in ascending order.
struct StagePlan {
  struct Piece {
    int slot = 0;   // of the owner's slot [doubles]
    int first = 0;  // equation
    int count = 0;
  };
  struct Source {
    int owner = 0;
    std::vector<Piece> pieces;
  };
  struct Part {
    std::vector<EquationRun> own;
    std::vector<EquationRun> shown;
    std::vector<Source> sources;
    EquationRun held;  // own equations and neighbours
  };
  std::vector<Part> parts;
  std::vector<int> values;

  StagePlan(const EquationGraph& graph, const std::vector<std::vector<int>>& shares) {
    const std::vector<int> owner = ownersOf(shares, graph.size());
    std::vector<int> place(at(graph.size()), -1);
    for (const std::vector<int>& share : shares) {
      Part part{.own = runsOf(share), .shown = {}, .sources = {}, .held = hullOf(share)};
      std::vector<int> shown;
      for (const int e : share) {
        part.held.first = std::min(part.held.first, graph.lowest(e));
        part.held.last = std::max(part.held.last, graph.highest(e) + 1);
        const std::vector<int>& around = graph.neighbours(e);
        if (std::all_of(around.begin(), around.end(), [&](int n) { return owner[at(n)] == owner[at(e)]; })) continue;
        place[at(e)] = 2 * static_cast<int>(shown.size());
        shown.push_back(e);
      }
      part.shown = runsOf(shown);
      values.push_back(2 * static_cast<int>(shown.size()));
      parts.push_back(std::move(part));
    }
    for (std::size_t thread = 0; thread < shares.size(); ++thread) {
      std::vector<int> read;
      for (const int e : shares[thread]) {
        for (const int n : graph.neighbours(e)) {
          if (owner[at(n)] != static_cast<int>(thread)) read.push_back(n);
        }
      }
      std::sort(read.begin(), read.end());
      read.erase(std::unique(read.begin(), read.end()), read.end());
      for (const int e : read) take(parts[thread], owner[at(e)], place[at(e)], e);
    }
  }

 private:
  static void take(Part& part, int owner, int place, int e) {
    auto source = std::find_if(part.sources.begin(), part.sources.end(),
                               [&](const Source& one) { return one.owner == owner; });
    if (source == part.sources.end()) {
      part.sources.push_back({owner, {}});
      source = part.sources.end() - 1;
    }
    if (!source->pieces.empty()) {
      Piece& last = source->pieces.back();
      if (last.first + last.count == e && last.slot + 2 * last.count == place) {
        ++last.count;
        return;
      }
    }
    source->pieces.push_back({place, e, 1});
  }
};

// One thread's equations. Its arrays hold the stretch of the state between the lowest and the highest equation that
// it computes or reads; entries in between that are neither stay zero.
class StageMember {
 public:
  StageMember(const CutRun& cut, const StagePlan& plan, Exchange& exchange, Member& me)
      : set_(cut.set()),
        me_(me),
        exchange_(exchange),
        part_(plan.parts[at(me.number())]),
        x_(at(2 * part_.held.size())),
        stage_(x_.size()),
        slope_(x_.size()),
        sum_(x_.size()) {
    std::copy_n(cut.x0().begin() + 2 * part_.held.first, x_.size(), x_.begin());
  }

  /// @param row     row(which): the input at the step's begin (0), middle (1), end (2)
  /// @param middle, end  called where the rows are first wanted, while others' values are on their way
  template <class Row, class Middle, class End>
  void step(double h, ChannelRun channels, Row row, Middle middle, End end) {
    me_.beginStep(epoch_ / 4);
    if (epoch_ > 0) take(x_);  // the start is known to all
    evaluate(x_, row(0), channels);
    forOwn([&](std::size_t i, int n) { afterFirstStage(h, &x_[i], &slope_[i], &sum_[i], &stage_[i], n); });
    show(stage_);
    middle();
    take(stage_);
    evaluate(stage_, row(1), channels);
    forOwn([&](std::size_t i, int n) { afterMiddleStage<1>(h, &x_[i], &slope_[i], &sum_[i], &stage_[i], n); });
    show(stage_);
    take(stage_);
    evaluate(stage_, row(1), channels);
    forOwn([&](std::size_t i, int n) { afterMiddleStage<2>(h, &x_[i], &slope_[i], &sum_[i], &stage_[i], n); });
    show(stage_);
    end();
    take(stage_);
    evaluate(stage_, row(2), channels);
    forOwn([&](std::size_t i, int n) { afterLastStage(h, &slope_[i], &sum_[i], &x_[i], n); });
    show(x_);
    me_.endStep(epoch_ / 4 - 1);
  }

  const double* x(int equation) const { return &x_[place(equation)]; }

 private:
  std::size_t place(int equation) const { return at(2 * (equation - part_.held.first)); }

  template <class Update>
  void forOwn(Update update) {
    for (const EquationRun& run : part_.own) update(place(run.first), 2 * run.size());
  }

  void evaluate(const std::vector<double>& x, const double* u, ChannelRun channels) {
    for (const EquationRun& run : part_.own) {
      set_.derivative({.first = run.first, .last = run.last, .x = x.data(), .x_first = part_.held.first, .u = u,
                       .u_first = channels.first, .u_count = channels.size(), .dx = slope_.data(),
                       .dx_first = part_.held.first});
    }
  }

  void show(const std::vector<double>& values) {
    ++epoch_;
    if (part_.sources.empty()) return;
    double* slot = exchange_.slot(me_.number(), epoch_);
    for (const EquationRun& run : part_.shown) {
      const double* from = &values[place(run.first)];
      for (int i = 0; i < 2 * run.size(); ++i) *slot++ = from[i];
    }
    exchange_.publish(me_, epoch_);
  }

  void take(std::vector<double>& values) {
    for (const StagePlan::Source& source : part_.sources) {
      const double* shown = exchange_.await(me_, source.owner, epoch_);
      for (const StagePlan::Piece& piece : source.pieces) {
        double* to = &values[place(piece.first)];
        for (int i = 0; i < 2 * piece.count; ++i) to[i] = shown[piece.slot + i];
      }
    }
  }

  const EquationSet& set_;
  Member& me_;
  Exchange& exchange_;
  const StagePlan::Part& part_;
  std::vector<double> x_, stage_, slope_, sum_;
  long epoch_ = 0;  // stages done
};

ChannelRun channelsOf(const EquationGraph& graph, const std::vector<EquationRun>& own) {
  ChannelRun all{};
  for (const EquationRun& run : own) {
    const ChannelRun more = graph.channels(run);
    if (more.size() == 0) continue;
    all = all.size() == 0 ? more : ChannelRun{std::min(all.first, more.first), std::max(all.last, more.last)};
  }
  return all;
}

// Every thread has the rows of its own channels from itself.
template <class Show>
bool walkWithOwnRows(const CutRun& cut, ChannelRun channels, const Schedule& schedule, FixedStep step,
                     StageMember& work, Show show) {
  if (isSwept(cut.input())) {
    SweptRows rows(cut.input());
    return walkSteps(
        schedule, step, SweptRows::kSteps, [&](const StepBlock& steps) { rows.sweep(steps); },
        [&](double h, int k) {
          work.step(
              h, {0, cut.set().channels()}, [&](int which) { return rows.row(2 * k + which); }, [] {}, [] {});
        },
        show);
  }
  OwnRows rows(cut.input(), channels);
  return walkSteps(
      schedule, step, kStepsPerBlock, [&](const StepBlock& steps) { rows.enter(steps); },
      [&](double h, int k) {
        rows.beginStep(k);
        work.step(
            h, channels, [&](int which) { return rows.row(which); }, [&] { rows.readMiddle(); },
            [&] { rows.readEnd(); });
      },
      show);
}

// One thread sweeps the rail a block ahead of all: a walk of its own, block by block.
class Sweeper {
 public:
  Sweeper(const Schedule& schedule, FixedStep step, std::vector<SweptRows>& rows) : rows_(rows) {
    constexpr int kWholeGrid = 1 << 30;
    walkSteps(
        schedule, step, kWholeGrid, [&](const StepBlock& grid) { grids_.push_back(grid); }, [](double, int) {},
        [](const StepPause&) { return true; });
  }
  /// Sweeps the next block of the walk, if there is one more.
  void sweepNext() {
    if (grid_ == grids_.size()) return;
    StepBlock block = grids_[grid_];
    block.first = done_;
    block.last = std::min(done_ + SweptRows::kSteps, block.last);
    rows_[static_cast<std::size_t>(number_++ % 2)].sweep(block);
    done_ = block.last;
    if (done_ < grids_[grid_].last) return;
    done_ = 0;
    ++grid_;
  }

 private:
  std::vector<SweptRows>& rows_;  // of the block in use and of the next
  std::vector<StepBlock> grids_;
  std::size_t grid_ = 0;
  int done_ = 0;  // steps of it
  long number_ = 0;
};

template <class Show>
bool walkWithSharedRows(const CutRun& cut, const Schedule& schedule, FixedStep step,
                        const std::vector<SweptRows>& rows, Sweeper* sweeper, StageMember& work, Show show) {
  const ChannelRun channels{0, cut.set().channels()};
  long block = -1;
  long swept = 0;
  return walkSteps(
      schedule, step, SweptRows::kSteps, [&](const StepBlock&) { ++block; },
      [&](double h, int k) {
        const SweptRows& swept_rows = rows[static_cast<std::size_t>(block % 2)];
        const auto row = [&](int which) { return swept_rows.row(2 * k + which); };
        // While the first values of the block are on their way: every reader has done with the block before.
        const auto middle = [&] {
          if (sweeper == nullptr || swept > block) return;
          swept = block + 1;
          sweeper->sweepNext();
        };
        work.step(h, channels, row, middle, [] {});
      },
      show);
}

}  // namespace

PartitionRun runStageExchange(const System& system, const Input& input, const Schedule& schedule, FixedStep step,
                              std::span<const double> x0, const Observer& observe, const PartitionChoice& choice) {
  const CutRun cut(system, input, x0);
  const EquationGraph graph(cut.set());
  PartitionRun run;
  run.shares = shareEquations(cut.set(), choice.map, choice.team.threads);
  const StagePlan plan(graph, run.shares);
  Exchange exchange(plan.values);
  SampleRing ring("rk4", choice.team.threads, cut.set().size(), observe);
  const Stretch& start = schedule.stretches().front();

  const bool shares_rail = choice.map == EquationMap::kPaper;
  std::vector<SweptRows> rows(shares_rail ? 2 : 0, SweptRows(cut.input()));
  std::optional<Sweeper> sweeper;
  if (shares_rail) {
    sweeper.emplace(schedule, step, rows);
    sweeper->sweepNext();
  }
  run.team = runTeam(choice.team, [&](Member& me) {
    if (me.number() == 0 && !ring.begin(me, start.segment, start.begin, x0)) return;
    StageMember work(cut, plan, exchange, me);
    const OwnState own(cut.set(), run.shares[at(me.number())]);
    const auto show = [&](const StepPause& here) {
      return ring.show(me, here, [&](double* x) { return own.copyTo(x, [&](int e) { return work.x(e); }); });
    };
    const bool sweeps = shares_rail && me.number() == kRailThread;
    const bool whole = shares_rail
                           ? walkWithSharedRows(cut, schedule, step, rows, sweeps ? &*sweeper : nullptr, work, show)
                           : walkWithOwnRows(cut, channelsOf(graph, plan.parts[at(me.number())].own), schedule, step,
                                             work, show);
    if (whole && me.number() == 0) ring.finish(me);
  });
  run.statistics = ring.statistics();
  run.statistics.evaluations = 4 * run.statistics.steps;
  return run;
}

}  // namespace vehicle
