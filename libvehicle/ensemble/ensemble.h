#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "libvehicle/ensemble/design.h"
#include "libvehicle/ensemble/isa.h"
#include "libvehicle/integrate/step_walk.h"
#include "libvehicle/result/column_summary.h"
#include "libvehicle/system/input.h"

namespace vehicle {

/// What all designs of a run share.
struct EnsembleRun {
  double output_step = 5e-3;        // [s] > 0
  FixedStep step;                   // of RK4, ended on samples and breakpoints as FixedSteps does
  double fastest = 0.0;             // [rad/s] of the designs: how closely samples lie (Sampling)
  int steps = 0;                    // fixed steps of an output step that samples have to end; 0: any (Sampling)
  double settle = 0.0;              // [s] >= 0: the start that is left out, up to the next output sample
  std::vector<FlatColumn> columns;  // what is computed, in this order
  Isa isa = bestIsa();
};

/// A design whose motion could not be followed to the end: its summaries are NaN, all others are untouched.
struct EnsembleFailure {
  int design = 0;
  double time = 0.0;  // [s] of the first sample at which a state is no longer finite
};

/// How far a design went, over the samples that count: where it left what the model can say.
struct DesignExtent {
  double lowest_load = 0.0;    // [N] of any wheel
  double largest_share = 0.0;  // of carbody pitch over kMostFlatPitch and travels over kMostFlatTravel
};

struct EnsembleResult {
  std::vector<ColumnSummary> summaries;   // (designs x columns), row-major; without the times of extremes
  std::vector<DesignExtent> extents;      // (designs)
  std::vector<EnsembleFailure> failures;  // by design, ascending
  long steps = 0;                         // RK4 steps, summed over designs
};

/// Histories of some designs of a run, as the kernel wrote them: for percentiles, spectra, whatever needs all samples.
/// Valid during the call that hands it out.
class StoredBlock {
 public:
  StoredBlock(int first, int designs, int lanes, int columns, const int* samples, int room, const double* values)
      : first_(first), designs_(designs), lanes_(lanes), columns_(columns), samples_(samples), room_(room),
        values_(values) {}

  [[nodiscard]] int firstDesign() const { return first_; }
  [[nodiscard]] int designs() const { return designs_; }
  [[nodiscard]] int columns() const { return columns_; }
  /// Samples that count, of one design of the block.
  [[nodiscard]] int samples(int design) const { return samples_[design]; }
  /// Value of a column (index into EnsembleRun::columns) at one of them. No meaning for a design that failed.
  /// @param design  0 .. designs() - 1, counted from firstDesign()
  [[nodiscard]] double at(int design, int column, int sample) const {
    const auto block = static_cast<std::size_t>(design / lanes_);
    const auto row = (block * static_cast<std::size_t>(room_) + static_cast<std::size_t>(sample)) *
                         static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    return values_[row * static_cast<std::size_t>(lanes_) + static_cast<std::size_t>(design % lanes_)];
  }
  /// A column of a design, shape (samples(design)).
  void copyColumn(int design, int column, std::vector<double>& values) const;

 private:
  int first_, designs_, lanes_, columns_;
  const int* samples_;    // (designs)
  int room_;              // rows that each block of lanes has
  const double* values_;  // (blocks x room x columns x lanes)
};

/// Called with the designs in ascending order, a few at a time; memory stays below about 64 MiB, whatever the number
/// of designs.
using StoredBlockSink = std::function<void(const StoredBlock&)>;

/// Number of the first output sample that counts: the first at or after `settle`, within a billionth of a step.
/// @param settle, output_step  [s] >= 0, > 0
[[nodiscard]] int firstCounted(double settle, double output_step);

/// Points of an output step of a run over that rail: designs with rails of their own can be run together where it is equal.
[[nodiscard]] int ensembleCut(const Input& rail, const EnsembleRun& run);

/// RK4 of many designs, one a SIMD lane, with metrics gathered on the way: the integrals and extremes of ColumnSummaries.
///
/// Every design follows the grid of FixedSteps over a measured Schedule: steps end on samples and breakpoints. What is
/// stored are the points of its regular grid; on a breakpoint the right-hand limit. A design gives the same bits in whatever company, lane and order it is computed, on the
/// same instruction set; differences between instruction sets and to the scalar run are roundings
/// (docs/theory/ensemble.md). Single-threaded and re-entrant: callers share designs among threads.
/// Cost: the rail is computed once a call, so hand over some hundred designs at once.
///
/// @param rail   4 channels in the order of the wheels 1 to 4, for all designs
/// @param store  empty: nothing is stored
/// @throws std::invalid_argument for a step, output step, settle, rail or column that does not fit
[[nodiscard]] EnsembleResult runEnsemble(std::span<const EnsembleDesign> designs, const Input& rail,
                                         const EnsembleRun& run, const StoredBlockSink& store = {});

/// The same with a rail for each design, where speed or wheel positions differ. The rails may differ in segments, breakpoints
/// and length, but an output step must be cut into the same number of points (ensembleCut()); designs that point to the
/// same Input share its preparation.
/// The rail is computed in the lanes, so the last bits differ from those of the other overload.
/// @param rails  (designs), none null
[[nodiscard]] EnsembleResult runEnsemble(std::span<const EnsembleDesign> designs, std::span<const Input* const> rails,
                                         const EnsembleRun& run, const StoredBlockSink& store = {});

}  // namespace vehicle
