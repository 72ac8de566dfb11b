#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "libvehicle/ensemble/kernel.h"
#include "libvehicle/ensemble/part_looks.h"
#include "libvehicle/integrate/step_walk.h"

namespace vehicle::ensemble {

/// The rail of a run that all designs share, in pieces of time small enough for a cache: rows of numbers and the
/// legs that read them. The grid and the numbers are those of FixedSteps.
class SharedRail {
 public:
  /// @param first_stored  number of the first point of the regular grid that is stored
  SharedRail(const Input& input, const Schedule& schedule, FixedStep step, int first_stored);

  /// The next piece; false where the run is over. The legs are valid until the next call.
  bool next();
  [[nodiscard]] const std::vector<SharedLeg>& legs() const { return legs_; }
  [[nodiscard]] long steps() const { return steps_; }  // so far

 private:
  void addSample(int segment, double t, const Look<double>& look);
  void beginPart(int segment, double t, int regular);
  void endInterval(const Interval& interval);
  void addBlock();

  const Input& input_;
  const Schedule& schedule_;
  FixedStep step_;
  int first_stored_;

  bool begun_ = false;
  Schedule::Iterator interval_;    // the one that is being run
  std::optional<PartLooks> part_;  // the one of the interval
  int number_ = 0;                 // of the next sample
  StepGrid grid_;
  int done_ = 0;             // steps of the grid
  int left_ = 0;             // steps of the interval
  long steps_ = 0;

  std::vector<double> rows_;     // (half steps x 8)
  std::vector<double> samples_;  // (samples x 12)
  std::size_t rows_used_ = 0, samples_used_ = 0;
  std::vector<SharedLeg> legs_;
};

}  // namespace vehicle::ensemble
