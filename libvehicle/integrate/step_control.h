#pragma once

#include "libvehicle/system/input.h"

namespace vehicle {

/// Tolerances of an adaptive method: local error <= absolute + relative |x|, per state, in the r.m.s. norm.
struct Accuracy {
  double relative = 1e-10;
  double absolute = 1e-12;
  double max_step =
      0.0;  // [s]; 0: the interval between two breakpoints, or a quarter of the input's shortest period there
};

/// Step sizes of an adaptive method from its error norms (1 = just tolerable): a PI controller, which grows and
/// shrinks the step without the see-saw of err^(-1/5) alone.
/// Source: Hairer, Norsett, Wanner I, 2nd ed., II.4 (4.13); Hairer, Wanner II, 2nd ed., IV.2 (2.43), beta = 0.04.
class StepControl {
 public:
  /// @param order  p + 1 of the local error estimate h^(p+1), e.g. 5 for a pair 5(4)
  explicit StepControl(int order);

  /// Size of the step after one of size h that was accepted with this error norm.
  [[nodiscard]] double afterAccepted(double h, double error_norm);
  /// Size of the next attempt after one that was not; NaN stands for an attempt that left the numbers.
  [[nodiscard]] double afterRejected(double h, double error_norm);

 private:
  double exponent_;
  double last_norm_ = 1e-4;
  bool rejected_ = false;
};

/// Longest step inside a segment of the input: a quarter of its shortest period, so that no sine can hide between
/// the stages of one long step through a vehicle at rest; infinite without sines. Everything narrower than that is
/// a segment of its own.
[[nodiscard]] double longestStep(const InputSegment& segment);

/// @throws std::invalid_argument unless 0 < absolute, 1e-14 <= relative < 1 (rounding and useful), max_step >= 0, all
///         finite
void checkAccuracy(const char* method, const Accuracy& accuracy);

}  // namespace vehicle
