#include "libvehicle/system/input.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "libvehicle/system/oscillator.h"

namespace vehicle {
namespace {

[[noreturn]] void refuse(std::size_t segment, const std::string& what) {
  throw std::invalid_argument("Input: segment " + std::to_string(segment) + ": " + what);
}

std::string text(double value) {
  std::ostringstream out;
  out.precision(17);
  out << value;
  return out.str();
}

void checkFinite(std::size_t segment, const char* name, const std::vector<double>& values) {
  const auto bad = std::find_if_not(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  if (bad != values.end()) {
    refuse(segment, std::string(name) + "[" + std::to_string(bad - values.begin()) + "] = " + text(*bad) +
                        ", must be finite");
  }
}

void checkSize(std::size_t segment, const char* name, std::size_t size, std::size_t expected) {
  if (size != expected) {
    refuse(segment, std::string(name) + " has " + std::to_string(size) + " values, must have " +
                        std::to_string(expected));
  }
}

void check(std::size_t index, int channels, const InputSegment& segment) {
  const std::size_t w = static_cast<std::size_t>(channels);
  const std::size_t frequencies = segment.angular_frequency.size();
  if (!std::isfinite(segment.begin) || !std::isfinite(segment.end) || !(segment.end > segment.begin)) {
    refuse(index, "lasts from " + text(segment.begin) + " s to " + text(segment.end) +
                      " s, must be finite and end after it begins");
  }
  checkSize(index, "cosine", segment.cosine.size(), w * frequencies);
  checkSize(index, "sine", segment.sine.size(), w * frequencies);
  checkSize(index, "polynomial", segment.polynomial.size(), w * InputSegment::kPolynomial);
  checkFinite(index, "angular_frequency", segment.angular_frequency);
  checkFinite(index, "cosine", segment.cosine);
  checkFinite(index, "sine", segment.sine);
  checkFinite(index, "polynomial", segment.polynomial);
  std::vector<double> sorted = segment.angular_frequency;
  std::sort(sorted.begin(), sorted.end());
  if (!sorted.empty() && !(sorted.front() > 0.0)) {
    refuse(index, "angular_frequency = " + text(sorted.front()) + " rad/s, must be > 0");
  }
  const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
  if (twin != sorted.end()) refuse(index, "angular_frequency " + text(*twin) + " rad/s stands there twice");
  for (const SampledTerm& term : segment.sampled) {
    if (term.motion == nullptr) refuse(index, "a sampled term has no motion");
    if (term.channel < 0 || term.channel >= channels) {
      refuse(index, "a sampled term is of channel " + std::to_string(term.channel) + ", must be 0.." +
                        std::to_string(channels - 1));
    }
    checkFinite(index, "weight of a sampled term", {term.weight});
  }
}

// The loops below run over a row of `width` = 2 w values. A width known to the compiler (four wheelsets: 8) becomes
// straight SIMD code; kWidth = 0 stands for any other. A row of frequency f is p = (cosine, w sine), then
// q = (sine, -w cosine): value += p cos(w s) + q sin(w s).
template <int kWidth>
inline void addRow(const double* __restrict p, const double* __restrict q, double c, double s, int width,
                   double* __restrict u) {
  const int n = kWidth > 0 ? kWidth : width;
  for (int k = 0; k < n; ++k) u[k] += p[k] * c + q[k] * s;
}

template <int kWidth>
inline void setPolynomialRow(const double* __restrict e, double s, int width, double* __restrict u) {
  const int n = kWidth > 0 ? kWidth : width;
  for (int k = 0; k < n; ++k) u[k] = e[k] + s * (e[n + k] + s * (e[2 * n + k] + s * e[3 * n + k]));
}

template <int kWidth>
inline void sweepOne(const double* __restrict p, Oscillator f, int count, int width, double* __restrict u) {
  const int n = kWidth > 0 ? kWidth : width;
  for (int i = 0; i < count; ++i, u += n, f.turn()) addRow<kWidth>(p, p + n, f.cosine, f.sine, width, u);
}

// Two frequencies in one pass: their rotations overlap, and a row is loaded and stored half as often.
template <int kWidth>
inline void sweepTwo(const double* __restrict p, Oscillator f, Oscillator g, int count, int width,
                     double* __restrict u) {
  const int n = kWidth > 0 ? kWidth : width;
  for (int i = 0; i < count; ++i, u += n, f.turn(), g.turn()) {
    for (int k = 0; k < n; ++k) {
      u[k] = (u[k] + (p[k] * f.cosine + p[n + k] * f.sine)) + (p[2 * n + k] * g.cosine + p[3 * n + k] * g.sine);
    }
  }
}

}  // namespace

double InputSegment::fastestSampled() const {
  double fastest = 0.0;
  for (const SampledTerm& term : sampled) fastest = std::max(fastest, term.motion->fastest());
  return fastest;
}

void requireClosedForm(const char* who, const char* remedy, const InputSegment& segment) {
  if (segment.sampled.empty()) return;
  std::string message = std::string(who) + ": the rail from t = " + text(segment.begin) +
                        " s on is known by samples, or passed at a changing speed, and has no closed form";
  if (*remedy != '\0') message += std::string("; ") + remedy;
  throw std::invalid_argument(message);
}

Input::Input(int channels, std::vector<InputSegment> segments) : channels_(channels), segments_(std::move(segments)) {
  if (channels < 1) throw std::invalid_argument("Input: channels = " + std::to_string(channels) + ", must be >= 1");
  if (segments_.empty()) throw std::invalid_argument("Input: no segments, must have at least one");
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    check(i, channels, segments_[i]);
    if (i > 0 && segments_[i].begin != segments_[i - 1].end) {
      refuse(i, "begins at " + text(segments_[i].begin) + " s, must begin where the one before ends, at " +
                    text(segments_[i - 1].end) + " s");
    }
    packRows(segments_[i]);
  }
}

void Input::packRows(const InputSegment& segment) {
  const std::size_t w = static_cast<std::size_t>(channels_);
  const std::size_t frequencies = segment.angular_frequency.size();
  Rows rows;
  rows.offset = rows_.size();
  const auto& p = segment.polynomial;
  rows.polynomial = std::any_of(p.begin(), p.end(), [](double v) { return v != 0.0; });
  if (rows.polynomial) {
    for (std::size_t power = 0; power < InputSegment::kPolynomial; ++power) {
      for (std::size_t j = 0; j < w; ++j) rows_.push_back(p[4 * j + power]);
      for (std::size_t j = 0; j < w; ++j) {
        rows_.push_back(power < 3 ? static_cast<double>(power + 1) * p[4 * j + power + 1] : 0.0);
      }
    }
  }
  for (std::size_t f = 0; f < frequencies; ++f) {
    const double omega = segment.angular_frequency[f];
    for (std::size_t j = 0; j < w; ++j) rows_.push_back(segment.cosine[j * frequencies + f]);
    for (std::size_t j = 0; j < w; ++j) rows_.push_back(omega * segment.sine[j * frequencies + f]);
    for (std::size_t j = 0; j < w; ++j) rows_.push_back(segment.sine[j * frequencies + f]);
    for (std::size_t j = 0; j < w; ++j) rows_.push_back(-omega * segment.cosine[j * frequencies + f]);
  }
  index_.push_back(rows);
}

template <int kWidth>
void Input::evaluateRows(const InputSegment& segment, Rows rows, double t, double* u, double* acceleration) const {
  const int width = kWidth > 0 ? kWidth : 2 * channels_;
  const double s = t - segment.begin;
  const double* row = rows_.data() + rows.offset;
  // Sums of a known width are kept in registers: going through u costs a store and a load a frequency.
  std::array<double, (kWidth > 0 ? kWidth : 1)> sums{};
  double* sum = kWidth > 0 ? sums.data() : u;
  const int w = width / 2;
  if (acceleration != nullptr) std::fill_n(acceleration, w, 0.0);
  if (rows.polynomial) {
    setPolynomialRow<kWidth>(row, s, width, sum);
    for (int j = 0; acceleration != nullptr && j < w; ++j) {
      acceleration[j] = 2.0 * row[2 * width + j] + 6.0 * row[3 * width + j] * s;
    }
    row += 4 * width;
  } else {
    std::fill_n(sum, width, 0.0);
  }
  for (const double omega : segment.angular_frequency) {
    const double sine = std::sin(omega * s);
    const double cosine = std::cos(omega * s);
    addRow<kWidth>(row, row + width, cosine, sine, width, sum);
    for (int j = 0; acceleration != nullptr && j < w; ++j) {
      acceleration[j] -= omega * omega * (row[j] * cosine + row[width + j] * sine);
    }
    row += 2 * width;
  }
  if constexpr (kWidth > 0) std::copy(sums.begin(), sums.end(), u);
}

void Input::evaluate(int segment, double t, std::span<double> u) const {
  assert(segment >= 0 && segment < segments());
  const std::size_t w = static_cast<std::size_t>(channels_);
  if (u.size() != 2 * w && u.size() != 3 * w) {
    throw std::invalid_argument("Input: u has " + std::to_string(u.size()) + " values, must have " +
                                std::to_string(2 * w) + ", or " + std::to_string(3 * w) + " with accelerations");
  }
  const auto index = static_cast<std::size_t>(segment);
  const InputSegment& holds = segments_[index];
  double* acceleration = u.size() == 3 * w ? u.data() + 2 * w : nullptr;
  switch (channels_) {  // one vehicle, and its bounce and pitch apart
    case 4:
      evaluateRows<8>(holds, index_[index], t, u.data(), acceleration);
      break;
    case 2:
      evaluateRows<4>(holds, index_[index], t, u.data(), acceleration);
      break;
    case 1:
      evaluateRows<2>(holds, index_[index], t, u.data(), acceleration);
      break;
    default:
      evaluateRows<0>(holds, index_[index], t, u.data(), acceleration);
  }
  if (!holds.sampled.empty()) addSampled(holds, {&t, 1}, u.data(), static_cast<int>(u.size()));
}

// Adds the sampled terms to rows of `width` values, one an instant, at most kBlock of them.
void Input::addSampled(const InputSegment& segment, std::span<const double> t, double* u, int width) const {
  std::array<RailState, kBlock> states;
  for (const SampledTerm& term : segment.sampled) {
    term.motion->evaluate(t, std::span(states).first(t.size()));
    double* value = u + term.channel;
    for (std::size_t i = 0; i < t.size(); ++i, value += width) {
      value[0] += term.weight * states[i].height;
      value[channels_] += term.weight * states[i].rate;
      if (width == 3 * channels_) value[2 * channels_] += term.weight * states[i].acceleration;
    }
  }
}

template <int kWidth>
void Input::sweepRows(const InputSegment& segment, Rows rows, double t0, double dt, int first, int count,
                      double* u) const {
  const int width = kWidth > 0 ? kWidth : 2 * channels_;
  for (int done = 0; done < count; done += kBlock) {
    const int n = std::min(kBlock, count - done);
    double* block = u + static_cast<std::ptrdiff_t>(done) * width;
    const double* row = rows_.data() + rows.offset;
    if (rows.polynomial) {
      for (int i = 0; i < n; ++i) {
        setPolynomialRow<kWidth>(row, (t0 + (first + done + i) * dt) - segment.begin, width, block + i * width);
      }
      row += 4 * width;
    } else {
      std::fill_n(block, n * width, 0.0);
    }
    const double s = (t0 + (first + done) * dt) - segment.begin;
    const std::vector<double>& omega = segment.angular_frequency;
    std::size_t f = 0;
    for (; f + 1 < omega.size(); f += 2, row += 4 * width) {
      sweepTwo<kWidth>(row, Oscillator(omega[f], s, dt), Oscillator(omega[f + 1], s, dt), n, width, block);
    }
    if (f < omega.size()) sweepOne<kWidth>(row, Oscillator(omega[f], s, dt), n, width, block);
    if (segment.sampled.empty()) continue;
    std::array<double, kBlock> times;
    for (int i = 0; i < n; ++i) times[static_cast<std::size_t>(i)] = t0 + (first + done + i) * dt;
    addSampled(segment, std::span<const double>(times).first(static_cast<std::size_t>(n)), block, width);
  }
}

void Input::requireSweep(int first, int count) {
  if (first < 0 || first % kBlock != 0 || count < 0) {
    throw std::invalid_argument("Input: sweep from sample " + std::to_string(first) + " over " +
                                std::to_string(count) + ", must start at a multiple of " + std::to_string(kBlock) +
                                " and not go backwards");
  }
}

void Input::sweep(int segment, double t0, double dt, int first, int count, std::span<double> u) const {
  assert(segment >= 0 && segment < segments());
  requireSweep(first, count);
  const std::size_t expected = static_cast<std::size_t>(count) * 2 * static_cast<std::size_t>(channels_);
  if (u.size() != expected) {
    throw std::invalid_argument("Input: sweep into " + std::to_string(u.size()) + " values, must be " +
                                std::to_string(expected) + " (count x 2 channels)");
  }
  const auto index = static_cast<std::size_t>(segment);
  const InputSegment& holds = segments_[index];
  switch (channels_) {
    case 4: sweepRows<8>(holds, index_[index], t0, dt, first, count, u.data()); break;
    case 2: sweepRows<4>(holds, index_[index], t0, dt, first, count, u.data()); break;
    case 1: sweepRows<2>(holds, index_[index], t0, dt, first, count, u.data()); break;
    default: sweepRows<0>(holds, index_[index], t0, dt, first, count, u.data());
  }
}

Input storedInput(int channels, double t0, double dt, std::span<const double> height, std::span<const double> rate) {
  if (channels < 1) {
    throw std::invalid_argument("storedInput: channels = " + std::to_string(channels) + ", must be >= 1");
  }
  const std::size_t w = static_cast<std::size_t>(channels);
  if (!std::isfinite(t0)) throw std::invalid_argument("storedInput: t0 = " + text(t0) + ", must be finite");
  if (!(dt > 0.0) || !std::isfinite(dt)) {
    throw std::invalid_argument("storedInput: dt = " + text(dt) + ", must be finite and > 0");
  }
  if (height.size() % w != 0 || height.size() < 2 * w || rate.size() != height.size()) {
    throw std::invalid_argument("storedInput: " + std::to_string(height.size()) + " heights and " +
                                std::to_string(rate.size()) + " rates, must be as many of each, " +
                                std::to_string(channels) + " a sample, of at least 2 samples");
  }
  for (std::size_t i = 0; i < height.size(); ++i) {
    if (!std::isfinite(height[i]) || !std::isfinite(rate[i])) {
      throw std::invalid_argument("storedInput: sample " + std::to_string(i / w) + ", channel " +
                                  std::to_string(i % w) + ": height = " + text(height[i]) + " m, rate = " +
                                  text(rate[i]) + " m/s, must be finite");
    }
  }
  std::vector<InputSegment> segments(height.size() / w - 1);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    InputSegment& piece = segments[i];
    piece.begin = t0 + static_cast<double>(i) * dt;
    piece.end = t0 + static_cast<double>(i + 1) * dt;
    // The length as the borders say it, not dt: the next piece starts where this one arrives.
    const double h = piece.end - piece.begin;
    for (std::size_t j = 0; j < w; ++j) {
      const double from = height[i * w + j];
      const double rise = height[(i + 1) * w + j] - from;
      const double rate_from = rate[i * w + j];
      const double rate_to = rate[(i + 1) * w + j];
      const double mean = rise / h;
      piece.polynomial.insert(piece.polynomial.end(), {from, rate_from, (3.0 * mean - 2.0 * rate_from - rate_to) / h,
                                                       (rate_from + rate_to - 2.0 * mean) / (h * h)});
    }
  }
  return Input(channels, std::move(segments));
}

}  // namespace vehicle
