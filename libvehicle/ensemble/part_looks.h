#pragma once

#include <cstddef>

#include "libvehicle/ensemble/kernel.h"
#include "libvehicle/system/sample_weights.h"
#include "libvehicle/system/schedule.h"

namespace vehicle::ensemble {

/// How the samples of a smooth part of a run are measured: what Recorder and ColumnSummaries do sample by sample, as
/// numbers that kernels read.
class PartLooks {
 public:
  PartLooks(const Schedule& schedule, const Schedule::Part& part);

  /// @param sample  0: the begin of the part, seen from inside; k: the end of its interval k - 1
  [[nodiscard]] Look<double> at(std::size_t sample) const;
  [[nodiscard]] std::size_t intervals() const { return intervals_; }

 private:
  bool counts_;
  std::size_t intervals_;
  double per_first_, per_point_, per_last_;  // [1/s]
  SampleWeights weights_;
};

}  // namespace vehicle::ensemble
