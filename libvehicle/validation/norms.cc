#include "libvehicle/validation/norms.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

namespace vehicle {
namespace {

double peakOf(std::span<const double> column) {
  double peak = 0.0;
  for (const double value : column) {
    if (!std::isfinite(value)) return std::numeric_limits<double>::quiet_NaN();
    peak = std::max(peak, std::abs(value));
  }
  return peak;
}

/// Trapezoidal mean of f(i): the two ends count half.
template <class F>
double meanOf(std::size_t samples, F f) {
  if (samples == 1) return f(0);
  double sum = 0.5 * (f(0) + f(samples - 1));
  for (std::size_t i = 1; i + 1 < samples; ++i) sum += f(i);
  return sum / static_cast<double>(samples - 1);
}

}  // namespace

Norms compareColumns(std::span<const double> reference, std::span<const double> other, double floor) {
  if (reference.size() != other.size() || reference.empty()) {
    throw std::invalid_argument(fmt::format(
        "compareColumns: {} samples against {}, must be equally many and at least 1", reference.size(), other.size()));
  }
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const std::size_t samples = reference.size();
  Norms norms;
  norms.peak = peakOf(reference);
  const double other_peak = peakOf(other);
  if (std::isnan(norms.peak) || std::isnan(other_peak)) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {norms.peak, nan, nan, nan, nan, nan, nan};
  }
  double low = reference[0];
  double high = reference[0];
  for (std::size_t i = 0; i < samples; ++i) {
    norms.max_difference = std::max(norms.max_difference, std::abs(other[i] - reference[i]));
    low = std::min(low, reference[i]);
    high = std::max(high, reference[i]);
  }

  const bool reference_is_zero = norms.peak <= floor;
  const bool other_is_zero = other_peak <= floor;
  if (reference_is_zero && other_is_zero) return norms;
  if (reference_is_zero || other_is_zero) {
    norms.relative = reference_is_zero ? kInfinite : norms.max_difference / norms.peak;
    norms.nrmse = norms.relative;
    norms.magnitude = reference_is_zero ? kInfinite : -1.0;
    norms.phase = 0.5;
    norms.combined = std::hypot(norms.magnitude, norms.phase);
    return norms;
  }

  // Scaled by the peaks, so that squares of 1e-200 or 1e200 stay numbers.
  const double m_scale = norms.peak;
  const double c_scale = other_peak;
  const auto m = [&](std::size_t i) { return reference[i] / m_scale; };
  const auto c = [&](std::size_t i) { return other[i] / c_scale; };
  const double m_size = std::sqrt(meanOf(samples, [&](std::size_t i) { return m(i) * m(i); }));
  const double c_size = std::sqrt(meanOf(samples, [&](std::size_t i) { return c(i) * c(i); }));
  const double difference = std::sqrt(meanOf(samples, [&](std::size_t i) {
    const double d = (other[i] - reference[i]) / m_scale;
    return d * d;
  }));
  const double range = (high - low) / m_scale;
  norms.relative = norms.max_difference / norms.peak;
  // A column that moves by no more than rounding is constant: its range would be noise in a denominator.
  norms.nrmse = difference / (range > 1e-12 ? range : 1.0);
  norms.magnitude = (c_size / m_size) * (c_scale / m_scale) - 1.0;
  const double apart = std::sqrt(meanOf(samples, [&](std::size_t i) {
    const double d = m(i) / m_size - c(i) / c_size;
    return d * d;
  }));
  const double together = std::sqrt(meanOf(samples, [&](std::size_t i) {
    const double s = m(i) / m_size + c(i) / c_size;
    return s * s;
  }));
  norms.phase = 2.0 * std::atan2(apart, together) / std::numbers::pi;
  norms.combined = std::hypot(norms.magnitude, norms.phase);
  return norms;
}

}  // namespace vehicle
