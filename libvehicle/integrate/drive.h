#pragma once

#include "libvehicle/integrate/integrator.h"

namespace vehicle {

/// The one run of every method: along the intervals of the schedule, with the observer at each sample.
///
/// @tparam Method  an Integrator; where the type is known and final, its steps are compiled into the loop
template <class Method>
Statistics drive(Method& method, const Schedule& schedule, std::span<const double> x0, const Observer& observe) {
  const Schedule::Intervals intervals = schedule.intervals();
  const Interval first = intervals.front();
  method.restart(first, x0);
  bool stopped = !observe(0, first.segment, first.begin, method.state());
  const Schedule::Iterator end = intervals.end();
  for (auto next = intervals.begin(); !stopped && !(next == end); ++next) {
    const Interval interval = *next;
    method.advance(interval);
    if (interval.sample >= 0) stopped = !observe(interval.sample, interval.next, interval.end, method.state());
  }
  Statistics statistics = method.statistics();
  statistics.stopped = stopped;
  return statistics;
}

/// Base of an integrator whose run() is compiled for its own type.
/// @tparam Method  the class that derives from it
template <class Method>
class DrivenByType : public Integrator {
 public:
  Statistics run(const Schedule& schedule, std::span<const double> x0, const Observer& observe) final {
    return drive(static_cast<Method&>(*this), schedule, x0, observe);
  }
};

/// The same with a copy of its own for the run, which leaves this object as it was: of a local object nobody else can hold the address, so that the compiler
/// keeps coefficients and stages of a small system in registers (a quarter of the time of a step of the flat form).
template <class Method>
class DrivenAsCopy : public Integrator {
 public:
  [[gnu::flatten]] Statistics run(const Schedule& schedule, std::span<const double> x0, const Observer& observe) final {
    Method own(static_cast<const Method&>(*this));
    return drive(own, schedule, x0, observe);
  }
};

}  // namespace vehicle
