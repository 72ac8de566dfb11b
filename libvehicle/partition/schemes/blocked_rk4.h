#pragma once

// The classical step as one pass over a long run of equations.
//
//   equations ->   e4      e3      e2      e1
//   stage 4     ###|=======|                        # done in the blocks before
//   stage 3     ###########|=======|                = done in this block, from the top down: stage 1 first
//   stage 2     ###################|=======|
//   stage 1     ###########################|=======|
//
// 1. Four passes, one a stage, would carry the state of a long train through the cache four times. Here a block of
//    stage 1 is followed at once by that part of stage 2 whose arguments are then complete, and so on: each stage lags
//    behind the one before by as many equations as an equation's neighbours are away. Nothing is computed twice.
// 2. Slopes, sums and stage values live only between e4 and e1, in a window that slides along; x is updated in place.
//    That is safe: an equation takes its last stage when all its neighbours have had their third, hence their first,
//    which is the one that reads x.
// 3. A thread that needs the new state of some equations only takes each stage of as many more as the next stage
//    reads: the redundant halo. With all equations wanted there is none, and this is the serial code.

#include <memory>
#include <optional>
#include <vector>

#include "libvehicle/integrate/integrator.h"
#include "libvehicle/integrate/step_walk.h"
#include "libvehicle/partition/map/equation_graph.h"
#include "libvehicle/partition/schemes/rail_rows.h"
#include "libvehicle/system/run_problem.h"

namespace vehicle {

/// Rk4 of the equations `target`, cache block by cache block, with the bits of Rk4::step.
/// Constructing allocates; a step never does. Looks at set and input, which must outlive it.
class BlockedRk4 {
 public:
  static constexpr int kBlock = 256;  // equations of stage 1 at a time; measured, docs/theory/partition.md

  /// @param input  with its channels in cut order
  /// @param block  equations of stage 1 at a time, >= 1
  BlockedRk4(const EquationSet& set, const EquationGraph& graph, const Input& input, EquationRun target,
             int block = kBlock);

  /// The equations whose (q, q') must stand in x() when a step begins: target and four neighbourhoods.
  [[nodiscard]] EquationRun held() const { return held_; }
  /// (q, q') of the equations held, from held().first on. A step moves those of the target and leaves the others.
  [[nodiscard]] double* x() { return x_.data(); }
  [[nodiscard]] double* x(int equation) { return x_.data() + 2 * (equation - held_.first); }

  [[nodiscard]] int blocks() const { return static_cast<int>(blocks_.size()); }
  /// The first block of a step that reads the state of that equation; blocks() where none does.
  [[nodiscard]] int firstBlockReading(int equation) const;

  /// Steps of a block of the walk that enter() expects at most.
  [[nodiscard]] int stepsOfBlock() const { return swept_ ? SweptRows::kSteps : kStepsPerBlock; }
  /// Before the steps of a block of the walk.
  void enter(const StepBlock& steps);
  /// The input of a step's first block, which no state enters: may be done while the state is still on its way.
  void prepare(int k);
  /// Step k of the block of the walk; prepare(k) must have gone before.
  /// @param before  before(int block): called before each block reads any state
  template <class Before>
  void step(double h, int k, Before before) {
    for (int b = 0; b < blocks(); ++b) {
      before(b);
      advance(h, k, b);
    }
    if (!swept_) begin_.swap(end_);
  }

 private:
  struct Block {
    EquationRun stage[4];
    ChannelRun middle;  // channels whose row at t + h/2 is read here for the first time
    ChannelRun end;     // the same at t + h, and those that the next step's first stage wants
    int keep = 0;       // the window holds nothing below any more
  };
  void plan(const EquationGraph& graph, EquationRun target, int block);
  void advance(double h, int k, int block);
  void slideTo(const Block& block);
  void readRow(int sample, ChannelRun channels, std::vector<double>& row);
  const double* row(int which, int k) const;
  void evaluate(EquationRun run, const double* x, int x_first, const double* row);

  const EquationSet& set_;
  const Input& input_;
  EquationRun held_;
  EquationRun first_stage_;  // equations of which stage 1 is taken
  ChannelRun channels_;      // that enter any stage
  std::vector<Block> blocks_;
  std::vector<int> reach_;   // (blocks) the last equation + 1 that blocks up to this one read

  std::optional<SweptRows> swept_;  // of few channels; else rows are read block by block
  PhasorTable clock_;
  std::vector<double> x_;
  std::vector<double> begin_, middle_, end_;  // rows over channels_: heights, then rates
  std::vector<double> part_;                  // of a row, as readRow() gives it
  std::vector<double> slope_;

  // The window: entry i belongs to equation base_ + i / 2.
  int base_ = 0;
  int filled_ = 0;    // stage 1 is done up to here
  int capacity_ = 0;  // [equations]
  std::vector<double> sum_, second_, third_, fourth_;  // weighted slopes; arguments of stages 2, 3, 4
};

/// rk4 of a system that can be cut, on the calling thread, cache block by cache block: the honest serial baseline of
/// every scheme. The bits of makeRk4().
/// @throws as makeRk4(), and std::invalid_argument if the system cannot be cut into equations
[[nodiscard]] std::unique_ptr<Integrator> makeBlockedRk4(const RunProblem& problem, FixedStep step);

}  // namespace vehicle
