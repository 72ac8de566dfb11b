#pragma once

#include <span>

#include "libvehicle/system/schedule.h"

namespace vehicle {

/// A method at work on one system and one input.
///
/// It is moved from interval to interval of a schedule (drive.h). No interval has a breakpoint inside, and each is run
/// with the formula of its segment to its very end, so that no step sees a jump and both limits are the one-sided ones.
/// Looks at system and input, which must outlive it.
class Integrator {
 public:
  virtual ~Integrator() = default;

  /// Stands at the begin of that interval with that state and knows nothing of what was before.
  /// @param x  (n)
  /// @throws std::invalid_argument unless x has n finite values
  virtual void restart(const Interval& at, std::span<const double> x) = 0;

  /// Moves to the end of the interval; it begins where the one before ended. An adaptive method may have stepped beyond
  /// and interpolates. Never allocates once the first intervals of each kind are done.
  /// @throws std::runtime_error  NaN, infinity or a step size at rounding level, with the time reached:
  ///                             "rk4: state 3 is no longer finite (...) at t = 0.35 s"
  virtual void advance(const Interval& interval) = 0;

  /// (n) where it stands. Valid until the next call of advance() or restart().
  [[nodiscard]] virtual std::span<const double> state() const = 0;

  /// What was done since it was made.
  [[nodiscard]] virtual Statistics statistics() const = 0;

  /// A whole run: drive() by its own type, of this object or of a copy.
  /// @param x0  (n) state at the schedule's first sample
  /// @return  what it cost
  virtual Statistics run(const Schedule& schedule, std::span<const double> x0, const Observer& observe) = 0;
};

}  // namespace vehicle
