#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <string>
#include <utility>

#include "libvehicle/system/input.h"
#include "libvehicle/system/oscillator.h"

// Some channels of an input: their rows from a shared clock, and the whole in another order.

namespace vehicle {
namespace {

// What each value of a row starts from.
void setRow(const double* __restrict e, bool polynomial, double s, std::ptrdiff_t width, int count,
            double* __restrict u) {
  if (!polynomial) {
    std::fill_n(u, count, 0.0);
    return;
  }
  for (int k = 0; k < count; ++k) u[k] = e[k] + s * (e[width + k] + s * (e[2 * width + k] + s * e[3 * width + k]));
}

// The same sums in the same order as a sweep has them: bits depend on it.
void addTwo(const double* __restrict p, const double* __restrict circle, std::ptrdiff_t width, int count,
            double* __restrict u) {
  const double c = circle[0], s = circle[1], c2 = circle[2], s2 = circle[3];
  for (int k = 0; k < count; ++k) {
    u[k] = (u[k] + (p[k] * c + p[width + k] * s)) + (p[2 * width + k] * c2 + p[3 * width + k] * s2);
  }
}

void addOne(const double* __restrict p, const double* __restrict circle, std::ptrdiff_t width, int count,
            double* __restrict u) {
  const double c = circle[0], s = circle[1];
  for (int k = 0; k < count; ++k) u[k] += p[k] * c + p[width + k] * s;
}

void copyChannel(const std::vector<double>& from, std::size_t channel, std::size_t channels,
                 std::vector<double>& to) {
  const std::size_t width = from.size() / channels;
  const auto first = from.begin() + static_cast<std::ptrdiff_t>(channel * width);
  to.insert(to.end(), first, first + static_cast<std::ptrdiff_t>(width));
}

}  // namespace

void Input::prepare(int segment, double t0, double dt, int first, int count, PhasorTable& clock) const {
  assert(segment >= 0 && segment < segments());
  requireSweep(first, count);
  const InputSegment& piece = segments_[static_cast<std::size_t>(segment)];
  const std::size_t frequencies = piece.angular_frequency.size();
  clock.segment = segment;
  clock.count = count;
  clock.time.resize(static_cast<std::size_t>(count));
  clock.instant.resize(static_cast<std::size_t>(count));
  clock.phasor.resize(static_cast<std::size_t>(count) * 2 * frequencies);
  for (int i = 0; i < count; ++i) {
    const double t = t0 + (first + i) * dt;
    clock.instant[static_cast<std::size_t>(i)] = t;
    clock.time[static_cast<std::size_t>(i)] = t - piece.begin;
  }
  for (std::size_t f = 0; f < frequencies; ++f) {
    for (int done = 0; done < count; done += kBlock) {
      const int end = std::min(done + kBlock, count);
      Oscillator oscillator(piece.angular_frequency[f], (t0 + (first + done) * dt) - piece.begin, dt);
      for (int i = done; i < end; ++i, oscillator.turn()) {
        double* circle = clock.phasor.data() + 2 * (static_cast<std::size_t>(i) * frequencies + f);
        circle[0] = oscillator.cosine;
        circle[1] = oscillator.sine;
      }
    }
  }
}

void Input::readRow(const PhasorTable& clock, int sample, int from, int to, double* u) const {
  assert(sample >= 0 && sample < clock.count && 0 <= from && from <= to && to <= channels_);
  const auto index = static_cast<std::size_t>(clock.segment);
  const std::size_t frequencies = segments_[index].angular_frequency.size();
  const bool polynomial = index_[index].polynomial;
  const std::ptrdiff_t width = 2 * channels_;
  const int count = to - from;
  for (const int rate : {0, 1}) {
    double* values = u + rate * count;
    // A level rail has no rows.
    const double* row = rows_.empty() ? nullptr : rows_.data() + index_[index].offset + rate * channels_ + from;
    const double* circle = clock.phasor.data() + 2 * frequencies * static_cast<std::size_t>(sample);
    setRow(row, polynomial, clock.time[static_cast<std::size_t>(sample)], width, count, values);
    if (polynomial) row += 4 * width;
    std::size_t f = 0;
    for (; f + 1 < frequencies; f += 2, row += 4 * width, circle += 4) addTwo(row, circle, width, count, values);
    if (f < frequencies) addOne(row, circle, width, count, values);
  }
  for (const SampledTerm& term : segments_[index].sampled) {
    if (term.channel < from || term.channel >= to) continue;
    RailState state;
    term.motion->evaluate({&clock.instant[static_cast<std::size_t>(sample)], 1}, {&state, 1});
    u[term.channel - from] += term.weight * state.height;
    u[count + term.channel - from] += term.weight * state.rate;
  }
}

Input Input::inOrder(std::span<const int> order) const {
  std::vector<int> sorted(order.begin(), order.end());
  std::sort(sorted.begin(), sorted.end());
  bool whole = order.size() == static_cast<std::size_t>(channels_);
  for (std::size_t i = 0; whole && i < sorted.size(); ++i) whole = sorted[i] == static_cast<int>(i);
  if (!whole) {
    throw std::invalid_argument("Input: an order of " + std::to_string(order.size()) + " channels, must name each of " +
                                std::to_string(channels_) + " once");
  }
  const auto w = static_cast<std::size_t>(channels_);
  std::vector<InputSegment> reordered;
  reordered.reserve(segments_.size());
  for (const InputSegment& from : segments_) {
    InputSegment to;
    to.begin = from.begin;
    to.end = from.end;
    to.angular_frequency = from.angular_frequency;
    for (SampledTerm term : from.sampled) {
      term.channel = static_cast<int>(std::find(order.begin(), order.end(), term.channel) - order.begin());
      to.sampled.push_back(std::move(term));
    }
    for (const int each : order) {
      copyChannel(from.cosine, static_cast<std::size_t>(each), w, to.cosine);
      copyChannel(from.sine, static_cast<std::size_t>(each), w, to.sine);
      copyChannel(from.polynomial, static_cast<std::size_t>(each), w, to.polynomial);
    }
    reordered.push_back(std::move(to));
  }
  return Input(channels_, std::move(reordered));
}

}  // namespace vehicle
