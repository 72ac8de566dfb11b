#include "libvehicle/partition/schemes/exact_rows.h"

#include <algorithm>

#include "libvehicle/integrate/exact_run.h"
#include "libvehicle/integrate/failure.h"
#include "libvehicle/partition/map/cut_order.h"
#include "libvehicle/partition/map/equation_graph.h"
#include "libvehicle/partition/map/equation_map.h"
#include "libvehicle/threads/exchange.h"

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// The rows of each share in the System's order, as runs.
std::vector<std::vector<RowRun>> rowsOf(const EquationSet& set, const std::vector<std::vector<int>>& shares) {
  std::vector<std::vector<RowRun>> rows;
  for (const std::vector<int>& share : shares) {
    std::vector<int> entries;
    for (const int e : share) {
      entries.push_back(set.stateOrder()[at(2 * e)]);
      entries.push_back(set.stateOrder()[at(2 * e + 1)]);
    }
    std::sort(entries.begin(), entries.end());
    rows.emplace_back();
    for (const EquationRun& run : runsOf(entries)) rows.back().push_back({run.first, run.size()});
  }
  return rows;
}

// Moves its own rows and takes the others' from their threads: every thread ends a step with the whole state.
class SharedRows {
 public:
  SharedRows(const std::vector<std::vector<RowRun>>& rows, Exchange& exchange, Member& me)
      : rows_(&rows), exchange_(&exchange), me_(&me) {}

  void move(ExactPropagator& propagator, const PolynomialGain* gain, const InputSegment& segment, double s,
            double* oscillators, Eigen::VectorXd& x) {
    me_->beginStep(epoch_);
    const std::vector<RowRun>& own = (*rows_)[at(me_->number())];
    ++epoch_;
    double* slot = exchange_->slot(me_->number(), epoch_);
    propagator.propagateRows(own, x.data(), oscillators, slot);
    if (gain != nullptr) gain->addRows(segment, s, own, slot);
    exchange_->publish(*me_, epoch_);
    place(slot, own, x);
    for (int other = 0; other < me_->threads(); ++other) {
      if (other == me_->number()) continue;
      place(exchange_->await(*me_, other, epoch_), (*rows_)[at(other)], x);
    }
    me_->endStep(epoch_ - 1);
  }

 private:
  static void place(const double* moved, const std::vector<RowRun>& rows, Eigen::VectorXd& x) {
    for (const RowRun& run : rows) {
      for (int i = 0; i < run.count; ++i) x[run.first + i] = *moved++;
    }
  }

  const std::vector<std::vector<RowRun>>* rows_;
  Exchange* exchange_;
  Member* me_;
  long epoch_ = 0;  // steps done
};

}  // namespace

PartitionRun runExactRows(const System& system, const Input& input, const Schedule& schedule,
                          std::span<const double> x0, const Observer& observe, const PartitionChoice& choice) {
  const StateSpace matrices = matricesForExact(system, input, x0);
  const EquationSet& set = equationsOf(system);
  PartitionRun run;
  // A row costs the same whatever its equation reads.
  run.shares = shareEquations(set, choice.map, choice.team.threads, std::vector<double>(set.equations().size(), 1.0));
  const std::vector<std::vector<RowRun>> rows = rowsOf(set, run.shares);
  std::vector<int> values;
  for (const std::vector<int>& share : run.shares) values.push_back(2 * static_cast<int>(share.size()));
  Exchange exchange(values);
  const Stretch first = schedule.stretches().front();
  Statistics& statistics = run.statistics;
  run.team = runTeam(choice.team, [&](Member& me) {
    const bool shows = me.number() == 0;
    if (shows && !observe(0, first.segment, first.begin, x0)) {
      statistics.stopped = true;
      me.stopTeam();
      return;
    }
    ExactRun exact(matrices, input, schedule, x0, SharedRows(rows, exchange, me));
    bool stopped = false;
    const Statistics mine = exact.run([&](const Stretch& stretch, std::span<const double> x) {
      if (!shows) return true;
      requireFinite("exact", stretch.end, x);
      if (stretch.sample >= 0) stopped = !observe(stretch.sample, stretch.next, stretch.end, x);
      return !stopped;
    });
    if (!shows) return;
    statistics = mine;
    statistics.stopped = stopped;
    if (stopped) me.stopTeam();
  });
  return run;
}

}  // namespace vehicle
