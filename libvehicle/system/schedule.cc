#include "libvehicle/system/schedule.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace vehicle {
namespace {

constexpr double kSameInstant = 1e-9;  // of an output step: closer than this, two instants are one

}  // namespace

int sampleAt(double begin, double output_step, double t) {
  const double steps = std::round((t - begin) / output_step);
  if (!(steps >= 0.0 && steps <= kMostSamples)) return -1;
  const double distance = std::abs(t - (begin + steps * output_step));
  return distance <= kSameInstant * output_step ? static_cast<int>(steps) : -1;
}

Schedule::Schedule(const Input& input, double output_step) : begin_(input.begin()), output_step_(output_step) {
  if (!(output_step > 0.0) || !std::isfinite(output_step)) {
    std::ostringstream message;
    message << "Schedule: output_step = " << output_step << " s, must be finite and > 0";
    throw std::invalid_argument(message.str());
  }
  const double steps = std::floor((input.end() - begin_) / output_step + kSameInstant);
  if (!(steps >= 1.0 && steps <= kMostSamples)) {
    std::ostringstream message;
    message << "Schedule: an input of " << input.end() - begin_ << " s is " << steps << " output steps of "
            << output_step << " s, must be 1.." << kMostSamples;
    throw std::invalid_argument(message.str());
  }
  samples_ = static_cast<int>(steps) + 1;

  const double same = kSameInstant * output_step;
  const int last_segment = input.segments() - 1;
  int segment = 0;
  double reached = begin_;
  const auto kink = [&] { return input.segment(segment).end; };  // meant only where segment < last_segment
  while (segment < last_segment && kink() - begin_ <= same) ++segment;
  for (int sample = 1; sample < samples_; ++sample) {
    const double at = time(sample);
    while (segment < last_segment && kink() < at - same) {
      // A segment shorter than the tolerance is passed over: its kinks are one.
      if (kink() - reached > same) {
        stretches_.push_back({segment, reached, kink(), -1, 0});
        reached = kink();
      }
      ++segment;
    }
    const bool on_border = kink() <= at + same;
    const double end = on_border ? kink() : at;
    const int holds = segment;
    while (segment < last_segment && kink() <= at + same) ++segment;
    stretches_.push_back({holds, reached, end, sample, 0});
    reached = end;
  }
  for (std::size_t i = 0; i + 1 < stretches_.size(); ++i) stretches_[i].next = stretches_[i + 1].segment;
  stretches_.back().next = segment;
}

}  // namespace vehicle
