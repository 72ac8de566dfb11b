#include "libvehicle/simulate/recorder.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"

namespace vehicle {

Recorder::Recorder(const System& system, const Input& input, const Schedule& schedule, Keep keep, bool measures,
                   const Progress& progress)
    : system_(system),
      input_(input),
      schedule_(schedule),
      keep_(keep),
      measures_(measures),
      progress_(progress),
      history_(system.outputs()),
      summaries_(measures ? system.outputs().size() : 0),
      u_(3 * static_cast<std::size_t>(system.channels())),
      y_(system.outputs().size()),
      next_(schedule.intervals().begin()) {
  if (keep == Keep::kOutputs) history_.reserve(static_cast<std::size_t>(schedule.outputs()));
}

void Recorder::evaluate(int segment, double t, std::span<const double> x) {
  input_.evaluate(segment, t, u_);
  system_.output(x, u_, y_);
  double zero = 0.0;
  for (const double each : y_) zero += 0.0 * each;
  if (zero == 0.0) return;
  const auto wrong = std::find_if_not(y_.begin(), y_.end(), [](double each) { return std::isfinite(each); });
  throw RunFailed(fmt::format("{} is not finite at t = {:.6g} s",
                              system_.outputs()[static_cast<std::size_t>(wrong - y_.begin())].name, t));
}

// The part that begins here; y_ holds its first values.
void Recorder::measureBegin(double t, std::span<const double> x) {
  weights_.reset();
  if (!next_.part().counts) return;
  weights_.emplace(schedule_, next_.part());
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

void Recorder::store(double t) {
  const std::span<double> row = history_.append(t);
  std::copy(y_.begin(), y_.end(), row.begin() + 1);
}

bool Recorder::operator()(int sample, int segment, double t, std::span<const double> x) {
  evaluate(segment, t, x);
  reached_ = t;
  bool kept = true;
  if (sample == 0) {
    if (measures_) measureBegin(t, x);
  } else {
    Interval interval = *next_;
    for (; interval.sample < 0; interval = *next_) ++next_;  // breakpoints that are no samples
    if (measures_) {
      measureEnd(interval, segment, t, x);
      const bool ends_part = next_.index() + 1 == next_.part().first_interval + next_.part().count;
      const bool ends_run = next_.index() + 1 == schedule_.intervals().size();
      ++next_;
      if (ends_part && !ends_run) measureBegin(t, x);
    } else {
      ++next_;
    }
    kept = keep_ == Keep::kRegular ? interval.regular >= 0 : interval.output >= 0;
  }
  if (kept) {
    ++outputs_;
    if (keep_ != Keep::kNothing) store(t);
  }
  // Asking after every sample would cost more than a step of the exact method.
  constexpr int kSamplesBetweenReports = 16;
  if (!progress_ || sample % kSamplesBetweenReports != 0) return true;
  return progress_(static_cast<double>(sample + 1) / schedule_.samples());
}

std::vector<ColumnSummary> Recorder::summaries() const {
  if (!measures_) return {};
  std::vector<ColumnSummary> made = summaries_.summaries();
  // A part that was broken off has no end to be integrated to.
  if (!exact_ || exact_->time() <= 0.0 || !(next_ == schedule_.intervals().end())) return made;
  for (std::size_t i = 0; i < made.size(); ++i) {
    made[i].mean = exact_->first()[i] / exact_->time();
    made[i].rms = std::sqrt(std::fmax(0.0, exact_->second()[i] / exact_->time()));
  }
  return made;
}

}  // namespace vehicle
