#include "libvehicle/integrate/exact_run.h"

#include <optional>
#include <stdexcept>

#include "libvehicle/integrate/failure.h"

namespace vehicle {
namespace {

constexpr const char* kName = "exact";

}  // namespace

StateSpace matricesForExact(const System& system, const Input& input, std::span<const double> x0) {
  checkChannels(kName, system.channels(), input.channels());
  checkStart(kName, x0, system.size());
  for (int s = 0; s < input.segments(); ++s) requireClosedForm(kName, "take rk4 or dopri5", input.segment(s));
  std::optional<StateSpace> matrices = system.linear();
  if (!matrices) {
    throw std::invalid_argument(
        "exact: the system is nonlinear (it has no matrices A, B); exact propagation needs a linear one, take rk4 or "
        "dopri5");
  }
  return std::move(*matrices);
}

Statistics runExact(const System& system, const Input& input, const Schedule& schedule, std::span<const double> x0,
                    const Observer& observe) {
  ExactRun run(matricesForExact(system, input, x0), input, schedule, x0);
  const Interval first = schedule.intervals().front();
  if (!observe(0, first.segment, first.begin, run.state())) return {.stopped = true};
  bool stopped = false;
  Statistics statistics = run.run([&](const Interval& interval, std::span<const double> x) {
    requireFinite(kName, interval.end, x);
    if (interval.sample >= 0) stopped = !observe(interval.sample, interval.next, interval.end, x);
    return !stopped;
  });
  statistics.stopped = stopped;
  return statistics;
}

}  // namespace vehicle
