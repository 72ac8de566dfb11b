#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "libvehicle/result/column_summary.h"
#include "libvehicle/result/time_history.h"
#include "libvehicle/simulate/exact_integrals.h"
#include "libvehicle/system/sample_weights.h"
#include "libvehicle/system/schedule.h"
#include "libvehicle/system/system.h"

namespace vehicle {

/// Called now and then with the share done, 0..1; returning false ends the run with what there is.
using Progress = std::function<bool(double)>;

/// Which samples of a run become its history.
enum class Keep {
  kOutputs,  // every output step
  kRegular,  // every point of the regular grid, which follows the fastest motion (schedule.h)
  kNothing,  // summaries alone: memory does not grow with the run
};

/// The observer of a run: turns states into columns, keeps the history, measures peaks and means, watches that every
/// number is finite.
///
/// A column may jump at a breakpoint of the rail: the part before it is measured up to the left-hand limit, the part
/// behind from the right-hand one on, which is also what the history holds.
class Recorder {
 public:
  /// @param measures  whether the schedule has the samples that summaries need, breakpoints included
  Recorder(const System& system, const Input& input, const Schedule& schedule, Keep keep, bool measures,
           const Progress& progress);

  /// Means are integrated in closed form from now on, instead of by weights: of a run without error of its own.
  void integrateExactly() { exact_.emplace(system_, input_, schedule_); }

  /// @throws RunFailed  a column is no longer finite; names it and the time
  bool operator()(int sample, int segment, double t, std::span<const double> x);

  [[nodiscard]] TimeHistory takeHistory() { return std::move(history_); }
  /// (columns after time); empty if nothing was measured
  [[nodiscard]] std::vector<ColumnSummary> summaries() const;
  [[nodiscard]] double reached() const { return reached_; }  // [s]
  [[nodiscard]] long outputs() const { return outputs_; }    // output samples seen

 private:
  void evaluate(int segment, double t, std::span<const double> x);
  void measureEnd(const Interval& interval, int segment, double t, std::span<const double> x);
  void measureBegin(double t, std::span<const double> x);
  void store(double t);

  const System& system_;
  const Input& input_;
  const Schedule& schedule_;
  Keep keep_;
  bool measures_;
  const Progress& progress_;
  TimeHistory history_;
  ColumnSummaries summaries_;
  std::vector<double> u_;                 // (3 w) heights, rates, accelerations
  std::vector<double> y_;                 // (columns after time)
  Schedule::Iterator next_;               // the interval that ends at the next sample
  std::optional<SampleWeights> weights_;  // of its part, where that counts
  std::optional<ExactIntegrals> exact_;
  double reached_ = 0.0;
  long outputs_ = 0;
};

}  // namespace vehicle
