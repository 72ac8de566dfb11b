#pragma once

#include <cstddef>
#include <vector>

#include "libvehicle/ensemble/kernel.h"
#include "libvehicle/integrate/fixed_step_run.h"

namespace vehicle::ensemble {

/// The rail of a run that all designs share, in pieces of time small enough for a cache: rows of numbers and the
/// legs that read them. The grid and the numbers are those of runFixedStep().
class SharedRail {
 public:
  /// @param first_counted  number of the first sample that counts   @param reads_rail  whether samples need the rail
  SharedRail(const Input& input, const Schedule& schedule, FixedStep step, int first_counted, bool reads_rail);

  /// The next piece; false where the run is over. The legs are valid until the next call.
  bool next();
  [[nodiscard]] const std::vector<SharedLeg>& legs() const { return legs_; }
  [[nodiscard]] long steps() const { return steps_; }  // so far

 private:
  void addSample(int number, int segment, double t, bool alone);
  void addBlock();

  const Input& input_;
  const Schedule& schedule_;
  FixedStep step_;
  int first_counted_;
  bool reads_rail_;

  bool begun_ = false;
  std::size_t stretch_ = 0;  // the one that is being run
  std::size_t first_ = 0;    // of the grid
  StepGrid grid_;
  int done_ = 0;             // steps of the grid
  int left_ = 0;             // steps of the stretch
  long steps_ = 0;

  std::vector<double> rows_;     // (half steps x 8)
  std::vector<double> samples_;  // (samples x 12)
  std::size_t rows_used_ = 0, samples_used_ = 0;
  std::vector<SharedLeg> legs_;
};

}  // namespace vehicle::ensemble
