#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "libvehicle/result/column_summary.h"
#include "libvehicle/result/history_sink.h"
#include "libvehicle/simulate/exact_integrals.h"
#include "libvehicle/system/run_problem.h"
#include "libvehicle/system/sample_weights.h"

namespace vehicle {

/// Called now and then with the share done, 0..1; returning false ends the run with what there is.
using Progress = std::function<bool(double)>;

/// Which samples of a run become its history.
enum class Keep {
  kOutputs,  // every output step
  kRegular,  // every point of the regular grid, which follows the fastest motion (schedule.h)
  kNothing,  // summaries alone: memory does not grow with the run
};

/// Where samples of a run go.
struct Keeper {
  HistorySink* sink = nullptr;
  Keep which = Keep::kOutputs;
};

/// What a run is watched for.
struct Watch {
  std::vector<Keeper> keepers;    // none: memory does not grow with the run
  Keep counted = Keep::kOutputs;  // which samples are counted: the regular ones, or those of the output
  bool measures = true;           // the schedule has the samples that summaries need, breakpoints included
  const Progress& progress;
};

/// The observer of a run: turns states into columns, hands samples out, measures peaks and means, watches that every
/// number is finite. Memory is that of one sample.
///
/// A column may jump at a breakpoint of the rail: the part before it is measured up to the left-hand limit, the part
/// behind from the right-hand one on, which is also what the history holds.
class Recorder {
 public:
  /// Begins all sinks. Looks at both: they outlive it.
  Recorder(const RunProblem& problem, const Watch& watch);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Means are integrated in closed form from now on, instead of by weights: of a run without error of its own.
  void integrateExactly() { exact_.emplace(problem_.system, problem_.input, problem_.schedule); }

  /// False too once a sink has failed.
  /// @throws RunFailed  a column is no longer finite; names it and the time
  bool operator()(int sample, int segment, double t, std::span<const double> x);

  /// Throws what a sink has thrown: that is no failure of the integration.
  void requireKept() const {
    if (failure_) std::rethrow_exception(failure_);
  }
  /// (columns after time); empty if nothing was measured
  [[nodiscard]] std::vector<ColumnSummary> summaries() const;
  [[nodiscard]] double reached() const { return reached_; }  // [s]
  [[nodiscard]] long outputs() const { return outputs_; }    // output samples seen

 private:
  void evaluate(int segment, double t, std::span<const double> x);
  void measureEnd(const Interval& interval, int segment, double t, std::span<const double> x);
  void measureBegin(double t, std::span<const double> x);

  const RunProblem& problem_;
  const Watch& watch_;
  ColumnSummaries summaries_;
  std::vector<double> u_;                 // (3 w) heights, rates, accelerations
  std::vector<double> row_;               // (columns) of the sample at hand, the time first
  std::span<double> y_;                   // those after the time
  Schedule::Iterator next_;               // the interval that ends at the next sample
  std::optional<SampleWeights> weights_;  // of its part, where that counts
  std::optional<ExactIntegrals> exact_;
  std::exception_ptr failure_;  // of a sink
  double reached_ = 0.0;
  long outputs_ = 0;
};

}  // namespace vehicle
