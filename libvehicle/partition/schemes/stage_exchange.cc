#include "libvehicle/partition/schemes/stage_exchange.h"

#include <algorithm>

#include "libvehicle/partition/schemes/rk4_stages.h"
#include "libvehicle/partition/schemes/stage_walk.h"

namespace vehicle {
namespace {

// One thread's equations. Its arrays hold the stretch of the state between the lowest and the highest equation that
// it computes or reads; entries in between that are neither stay zero.
class StageMember {
 public:
  explicit StageMember(const StageSeat& seat)
      : set_(seat.cut.set()),
        me_(seat.me),
        exchange_(seat.exchange),
        part_(seat.part),
        x_(static_cast<std::size_t>(2 * part_.held.size())),
        stage_(x_.size()),
        slope_(x_.size()),
        sum_(x_.size()) {
    std::copy_n(seat.cut.x0().begin() + 2 * part_.held.first, x_.size(), x_.begin());
  }

  template <class Rows>
  void step(double h, Rows& rows) {
    me_.beginStep(epoch_ / 4);
    if (epoch_ > 0) take(x_);  // the start is known to all
    evaluate(x_, rows.row(0), rows.channels());
    forOwn([&](std::size_t i, int n) { afterFirstStage(h, &x_[i], &slope_[i], &sum_[i], &stage_[i], n); });
    show(stage_);
    rows.afterStage(0);
    take(stage_);
    evaluate(stage_, rows.row(1), rows.channels());
    forOwn([&](std::size_t i, int n) { afterMiddleStage<1>(h, &x_[i], &slope_[i], &sum_[i], &stage_[i], n); });
    show(stage_);
    rows.afterStage(1);
    take(stage_);
    evaluate(stage_, rows.row(1), rows.channels());
    forOwn([&](std::size_t i, int n) { afterMiddleStage<2>(h, &x_[i], &slope_[i], &sum_[i], &stage_[i], n); });
    show(stage_);
    rows.afterStage(2);
    take(stage_);
    evaluate(stage_, rows.row(2), rows.channels());
    forOwn([&](std::size_t i, int n) { afterLastStage(h, &slope_[i], &sum_[i], &x_[i], n); });
    show(x_);
    rows.afterStage(3);
    me_.endStep(epoch_ / 4 - 1);
  }

  const double* x(int equation) const { return &x_[place(equation)]; }

 private:
  std::size_t place(int equation) const { return static_cast<std::size_t>(2 * (equation - part_.held.first)); }

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
      for (const ShownPiece& piece : source.pieces) {
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

}  // namespace

PartitionRun runStageExchange(const System& system, const Input& input, const Schedule& schedule, FixedStep step,
                              std::span<const double> x0, const Observer& observe, const PartitionChoice& choice) {
  return runStages(system, input, schedule, step, x0, observe, choice, false, [](const StageSeat& seat, auto walk) {
    StageMember work(seat);
    return walk(work);
  });
}

}  // namespace vehicle
