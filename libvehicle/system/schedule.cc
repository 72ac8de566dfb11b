#include "libvehicle/system/schedule.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>

namespace vehicle {
namespace {

/// Whether the rail does that for longer than two periods; a dip is over sooner.
bool lasts(const InputSegment& segment, double angular_frequency) {
  return angular_frequency * (segment.end - segment.begin) > 4.0 * std::numbers::pi;
}

/// The fastest harmonic of what is passed quickly [rad/s]; 0 where there is none.
double fastestPassing(const InputSegment& segment) {
  double fastest = 0.0;
  for (const double omega : segment.angular_frequency) {
    if (!lasts(segment, omega)) fastest = std::max(fastest, omega);
  }
  const double sampled = segment.fastestSampled();
  return lasts(segment, sampled) ? fastest : std::max(fastest, sampled);
}

[[noreturn]] void refuse(const std::ostringstream& message) { throw std::invalid_argument(message.str()); }

std::size_t at(std::int64_t count) { return static_cast<std::size_t>(count); }

}  // namespace

SampleGrid::SampleGrid(double begin, double step) : begin_(begin), step_(step) {
  double denominator = 1.0;
  for (int digits = 0; digits <= 12; ++digits, denominator *= 10.0) {
    const double numerator = std::round(step * denominator);
    if (!(numerator > 0.0 && numerator < 1e9 && numerator / denominator == step)) continue;
    numerator_ = numerator;
    denominator_ = denominator;
    return;
  }
}

double SampleGrid::time(std::int64_t i, int cut) const {
  // Both are whole numbers below 2^53, so the division rounds once.
  const double numerator = static_cast<double>(i) * numerator_;
  const double denominator = denominator_ * cut;
  if (numerator_ > 0.0 && numerator < 0x1p53 && denominator < 0x1p53) return begin_ + numerator / denominator;
  const std::int64_t whole = i / cut;
  return begin_ + static_cast<double>(whole) * step_ + static_cast<double>(i - whole * cut) * (step_ / cut);
}

int sampleAt(double begin, double output_step, double t) {
  const double steps = std::round((t - begin) / output_step);
  if (!(steps >= 0.0 && steps <= kMostSamples)) return -1;
  const double distance = std::abs(t - SampleGrid(begin, output_step).time(static_cast<std::int64_t>(steps)));
  return distance <= kSameInstant * output_step ? static_cast<int>(steps) : -1;
}

Schedule::Schedule(const Input& input, double output_step)
    : begin_(input.begin()),
      end_(input.end()),
      sampling_{.output_step = output_step},
      grid_(begin_, output_step),
      measures_(false) {
  addParts(input);
}

Schedule::Schedule(const Input& input, const Sampling& sampling)
    : begin_(input.begin()),
      end_(input.end()),
      sampling_(sampling),
      grid_(begin_, sampling.output_step),
      measures_(true) {
  addParts(input);
}

/// Points that an output step must be cut into for a motion of that frequency.
int Schedule::cutOf(double angular_frequency) const {
  // What rounding makes of an eigenvalue must not decide.
  constexpr double kRounding = 1e-6;
  const double wanted =
      std::ceil(sampling_.output_step * angular_frequency * kPointsPerTurn / (2.0 * std::numbers::pi) - kRounding);
  return static_cast<int>(std::clamp(wanted, 1.0, 1e9));
}

/// The smallest cut that is at least `wanted`, a multiple of another, and lets points end fixed steps.
int Schedule::fitting(int wanted, int multiple_of) const {
  if (sampling_.steps == 0) return (wanted + multiple_of - 1) / multiple_of * multiple_of;
  for (int cut = std::max(wanted, multiple_of); cut < sampling_.steps; ++cut) {
    if (cut % multiple_of == 0 && sampling_.steps % cut == 0) return cut;
  }
  return sampling_.steps;
}

/// The regular grid: close enough for the system and for the harmonics of the rail that last.
void Schedule::chooseCut(const Input& input) {
  double fastest = sampling_.fastest;
  for (int s = 0; s < input.segments(); ++s) {
    const InputSegment& segment = input.segment(s);
    for (const double omega : segment.angular_frequency) {
      if (lasts(segment, omega)) fastest = std::max(fastest, omega);
    }
    const double sampled = segment.fastestSampled();
    if (lasts(segment, sampled)) fastest = std::max(fastest, sampled);
  }
  const double most = std::max(1.0, std::floor(kMostRunSamples * sampling_.output_step / (end_ - begin_)));
  const int wanted = cutOf(fastest);
  const int possible = static_cast<int>(std::min(static_cast<double>(wanted), most));
  cut_ = fitting(possible, 1);
  resolved_ = cut_ >= wanted;
}

void Schedule::addParts(const Input& input) {
  const double output_step = sampling_.output_step;
  if (!(output_step > 0.0) || !std::isfinite(output_step)) {
    std::ostringstream message;
    message << "Schedule: output_step = " << output_step << " s, must be finite and > 0";
    refuse(message);
  }
  const double steps = std::floor((end_ - begin_) / output_step + kSameInstant);
  if (!(steps >= 1.0 && steps <= kMostSamples)) {
    std::ostringstream message;
    message << "Schedule: an input of " << end_ - begin_ << " s is " << steps << " output steps of " << output_step
            << " s, must be 1.." << kMostSamples;
    refuse(message);
  }
  if (measures_) chooseCut(input);
  const double same = kSameInstant * output_step;
  const double count_from = measures_ ? sampling_.count_from : begin_;
  double reached = begin_;
  for (int s = 0; s < input.segments(); ++s) {
    const InputSegment& segment = input.segment(s);
    // A segment shorter than the tolerance is passed over: its breakpoints are one.
    if (segment.end - reached <= same) continue;
    Part part;
    part.segment = s;
    if (measures_) {
      part.cut = fitting(std::max(cut_, cutOf(fastestPassing(segment))), cut_);
      part.finer = part.cut / cut_;
    }
    for (const double border : {count_from, segment.end}) {
      if (border <= reached + same || border > segment.end) continue;
      part.begin = reached;
      part.end = border;
      part.counts = measures_ && reached >= count_from - same;
      addPart(part);
      reached = border;
    }
  }
  for (std::size_t i = 0; i + 1 < parts_.size(); ++i) parts_[i].next = parts_[i + 1].segment;
  parts_.back().segment_end = parts_.back().end;
  for (std::size_t i = parts_.size() - 1; i-- > 0;) {
    parts_[i].segment_end = parts_[i].next == parts_[i].segment ? parts_[i + 1].segment_end : parts_[i].end;
  }
  parts_.back().next = input.segments() - 1;  // what is left of the input is shorter than the tolerance
}

void Schedule::addPart(const Part& wanted) {
  Part part = wanted;
  const double same = kSameInstant * sampling_.output_step;
  const double point_step = sampling_.output_step / part.cut;
  const auto time = [&](std::int64_t point) { return pointTime(part, point); };
  part.first = static_cast<std::int64_t>(std::floor((part.begin - begin_) / point_step));
  while (time(part.first) <= part.begin + same) ++part.first;
  std::int64_t last = std::max(part.first, static_cast<std::int64_t>(std::ceil((part.end - begin_) / point_step)));
  while (last > part.first && time(last - 1) >= part.end - same) --last;
  // Points first .. last-1 lie inside; point `last` is the end, or beyond it.
  part.count = at(last - part.first) + 1;
  const bool on_point = time(last) - part.end <= same;
  const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(part.end), point_step);
  part.first_whole = std::abs(part.begin - time(part.first - 1)) <= rounding;
  part.last_whole = std::abs(time(last) - part.end) <= rounding;

  const bool at_end = end_ - part.end <= same;
  part.shown = measures_ || on_point || at_end;
  part.first_interval = interval_count_;
  part.first_sample = samples_;
  const auto number = [&](std::int64_t every) { return on_point && last % every == 0 ? last / every : -1; };
  part.last_output = static_cast<int>(number(part.cut));
  part.last_regular = static_cast<int>(number(part.finer));
  // The end of the run is kept, wherever it lies.
  if (at_end && part.last_output < 0) {
    part.last_output = static_cast<int>((last - 1) / part.cut) + 1;
  }
  interval_count_ += part.count;
  samples_ += static_cast<int>(part.count) - (part.shown ? 0 : 1);
  if (at_end) outputs_ = part.last_output + 1;
  parts_.push_back(part);
}

const Schedule::Part& Schedule::partOf(std::size_t interval) const {
  const auto after = std::upper_bound(parts_.begin(), parts_.end(), interval,
                                      [](std::size_t index, const Part& part) { return index < part.first_interval; });
  return *(after - 1);
}

Interval Schedule::intervalOf(const Part& part, std::size_t index) const {
  const std::size_t own = index - part.first_interval;
  const bool is_first = own == 0;
  const bool is_last = own + 1 == part.count;
  const auto point = part.first + static_cast<std::int64_t>(own);  // at its end, unless it is the last
  Interval interval;
  interval.segment = part.segment;
  interval.begin = is_first ? part.begin : pointTime(part, point - 1);
  interval.end = is_last ? part.end : pointTime(part, point);
  interval.next = is_last ? part.next : part.segment;
  if ((!is_first || part.first_whole) && (!is_last || part.last_whole)) {
    interval.whole = sampling_.output_step / part.cut;
    interval.alike = part.count - own - (part.last_whole ? 0 : 1);
  }
  interval.segment_end = part.segment_end;
  if (is_last) {
    if (part.shown) interval.sample = part.first_sample + static_cast<int>(own);
    interval.output = part.last_output;
    interval.regular = part.last_regular;
    return interval;
  }
  interval.sample = part.first_sample + static_cast<int>(own);
  if (point % part.cut == 0) interval.output = static_cast<int>(point / part.cut);
  if (point % part.finer == 0) interval.regular = static_cast<int>(point / part.finer);
  return interval;
}

double Schedule::time(int sample) const {
  if (sample <= 0) return begin_;
  const auto after = std::upper_bound(parts_.begin(), parts_.end(), sample,
                                      [](int number, const Part& part) { return number < part.first_sample; });
  const Part& part = *(after - 1);
  return intervalOf(part, part.first_interval + at(sample - part.first_sample)).end;
}

}  // namespace vehicle
