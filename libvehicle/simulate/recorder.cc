#include "libvehicle/simulate/recorder.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"

namespace vehicle {

namespace {

bool isOf(Keep which, const Interval& interval) {
  return which == Keep::kRegular ? interval.regular >= 0 : interval.output >= 0;
}

}  // namespace

Recorder::Recorder(const RunProblem& problem, const Watch& watch)
    : problem_(problem),
      watch_(watch),
      summaries_(watch.measures ? problem.system.outputs().size() : 0),
      u_(3 * static_cast<std::size_t>(problem.system.channels())),
      row_(problem.system.outputs().size() + 1),
      y_(std::span(row_).subspan(1)),
      next_(problem.schedule.intervals().begin()) {
  std::vector<Channel> columns = {{"time", "s"}};
  columns.insert(columns.end(), problem.system.outputs().begin(), problem.system.outputs().end());
  for (const Keeper& each : watch.keepers) {
    const long samples = problem.schedule.outputs();
    each.sink->begin(columns, each.which == Keep::kRegular ? samples * problem.schedule.cut() : samples);
  }
}

void Recorder::evaluate(int segment, double t, std::span<const double> x) {
  problem_.input.evaluate(segment, t, u_);
  problem_.system.output(x, u_, y_);
  double zero = 0.0;
  for (const double each : y_) zero += 0.0 * each;
  if (zero == 0.0) return;
  const auto wrong = std::find_if_not(y_.begin(), y_.end(), [](double each) { return std::isfinite(each); });
  throw RunFailed(fmt::format("{} is not finite at t = {:.6g} s",
                              problem_.system.outputs()[static_cast<std::size_t>(wrong - y_.begin())].name, t));
}

// The part that begins here; y_ holds its first values.
void Recorder::measureBegin(double t, std::span<const double> x) {
  weights_.reset();
  if (!next_.part().counts) return;
  weights_.emplace(problem_.schedule, next_.part());
  if (exact_) exact_->begin(next_.part(), t, x);
  summaries_.begin(t, (*weights_)[0], y_);
}

// The sample at the end of an interval, seen from the interval.
void Recorder::measureEnd(const Interval& interval, int segment, double t, std::span<const double> x) {
  if (!weights_) return;
  if (interval.segment != segment) evaluate(interval.segment, t, x);
  const std::size_t own = next_.index() - next_.part().first_interval;
  summaries_.add(t, (*weights_)[own + 1], y_);
  if (exact_) exact_->add(own, t, x, y_);
  if (interval.segment != segment) evaluate(segment, t, x);
}

bool Recorder::operator()(int sample, int segment, double t, std::span<const double> x) {
  evaluate(segment, t, x);
  reached_ = t;
  Interval interval{.output = 0, .regular = 0};  // the start is of all kinds
  if (sample == 0) {
    if (watch_.measures) measureBegin(t, x);
  } else {
    for (interval = *next_; interval.sample < 0; interval = *next_) ++next_;  // breakpoints that are no samples
    if (watch_.measures) {
      measureEnd(interval, segment, t, x);
      const bool ends_part = next_.index() + 1 == next_.part().first_interval + next_.part().count;
      const bool ends_run = next_.index() + 1 == problem_.schedule.intervals().size();
      ++next_;
      if (ends_part && !ends_run) measureBegin(t, x);
    } else {
      ++next_;
    }
  }
  if (isOf(watch_.counted, interval)) ++outputs_;
  row_[0] = t;
  try {
    for (const Keeper& each : watch_.keepers) {
      if (isOf(each.which, interval)) each.sink->add(row_);
    }
  } catch (...) {
    failure_ = std::current_exception();
    return false;
  }
  // Asking after every sample would cost more than a step of the exact method.
  constexpr int kSamplesBetweenReports = 16;
  if (!watch_.progress || sample % kSamplesBetweenReports != 0) return true;
  return watch_.progress(static_cast<double>(sample + 1) / problem_.schedule.samples());
}

std::vector<ColumnSummary> Recorder::summaries() const {
  if (!watch_.measures) return {};
  std::vector<ColumnSummary> made = summaries_.summaries();
  // A part that was broken off has no end to be integrated to.
  if (!exact_ || exact_->time() <= 0.0 || !(next_ == problem_.schedule.intervals().end())) return made;
  for (std::size_t i = 0; i < made.size(); ++i) {
    made[i].mean = exact_->first()[i] / exact_->time();
    made[i].rms = std::sqrt(std::fmax(0.0, exact_->second()[i] / exact_->time()));
  }
  return made;
}

}  // namespace vehicle
