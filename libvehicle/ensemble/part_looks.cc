#include "libvehicle/ensemble/part_looks.h"

#include <limits>

namespace vehicle::ensemble {

namespace {

double lengthOf(const Interval& interval) { return interval.end - interval.begin; }

}  // namespace

PartLooks::PartLooks(const Schedule& schedule, const Schedule::Part& part)
    : counts_(part.counts),
      intervals_(part.count),
      per_first_(1.0 / lengthOf(schedule.intervals()[part.first_interval])),
      per_point_(part.cut / schedule.outputStep()),
      per_last_(1.0 / lengthOf(schedule.intervals()[part.first_interval + part.count - 1])),
      weights_(schedule, part) {}

Look<double> PartLooks::at(std::size_t sample) const {
  if (!counts_) return {};
  const auto per = [&](std::size_t interval) {
    return interval == 0 ? per_first_ : interval + 1 == intervals_ ? per_last_ : per_point_;
  };
  Look<double> look;
  look.weight = weights_[sample];
  // A weight of 0 would say that the sample does not count.
  if (look.weight == 0.0) look.weight = std::numeric_limits<double>::min();
  if (sample >= 1) look.per_last = per(sample - 1);
  if (sample >= 2) look.per_before = per(sample - 2);
  return look;
}

}  // namespace vehicle::ensemble
