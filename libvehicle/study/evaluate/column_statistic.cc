#include "libvehicle/study/evaluate/column_statistic.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

namespace vehicle {

double percentileOf(std::vector<double>& values, double q) {
  const double place = q * static_cast<double>(values.size() - 1);
  const auto below = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), below, values.end());
  if (below + 1 == values.end()) return *below;
  const double above = *std::min_element(below + 1, values.end());
  return *below + (place - std::floor(place)) * (above - *below);
}

double ColumnStatistic::operator()(const Metric& metric, std::span<const double> values, double step) {
  const auto n = static_cast<double>(values.size());
  double sum = 0.0;
  switch (metric.statistic) {
    case Statistic::kRms:
      for (const double each : values) sum += each * each;
      return std::sqrt(sum / n);
    case Statistic::kMean:
      for (const double each : values) sum += each;
      return sum / n;
    case Statistic::kPeak:
      for (const double each : values) sum = std::max(sum, std::abs(each));
      return sum;
    case Statistic::kMin:
      return *std::min_element(values.begin(), values.end());
    case Statistic::kMax:
      return *std::max_element(values.begin(), values.end());
    case Statistic::kPercentile:
      sorted_.assign(values.begin(), values.end());
      return percentileOf(sorted_, metric.percent / 100.0);
    case Statistic::kAbsolutePercentile:
      sorted_.resize(values.size());
      std::transform(values.begin(), values.end(), sorted_.begin(), [](double each) { return std::abs(each); });
      return percentileOf(sorted_, metric.percent / 100.0);
    case Statistic::kBand:
      return band(values, step, metric.low, metric.high);
  }
  return 0.0;
}

double ColumnStatistic::band(std::span<const double> samples, double step, double low, double high) {
  // The last sample ends the last step: with it the lines would lie at multiples of 1/(T + dt).
  const std::span<const double> values = samples.first(std::max<std::size_t>(samples.size(), 2) - 1);
  const std::size_t n = values.size();
  if (circle_.size() != 2 * n) {
    circle_.resize(2 * n);
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
      circle_[2 * i] = std::cos(angle);
      circle_[2 * i + 1] = std::sin(angle);
    }
  }
  const double line = 1.0 / (static_cast<double>(n) * step);  // [Hz] between two lines
  // A bound that is meant to be a line is one.
  constexpr double kSameLine = 1e-9;
  const double beyond = static_cast<double>(n / 2 + 1);  // no line; a bound far above may exceed every integer
  const auto first = static_cast<std::size_t>(std::clamp(std::ceil(low / line - kSameLine), 0.0, beyond));
  double sum = 0.0;
  bool any = false;
  for (std::size_t k = first; 2 * k <= n && static_cast<double>(k) < high / line - kSameLine; ++k) {
    double cosine = 0.0;
    double sine = 0.0;
    std::size_t place = 0;  // k i modulo n
    for (std::size_t i = 0; i < n; ++i) {
      cosine += values[i] * circle_[2 * place];
      sine += values[i] * circle_[2 * place + 1];
      place += k;
      if (place >= n) place -= n;
    }
    sum += (k == 0 || 2 * k == n ? 1.0 : 2.0) * (cosine * cosine + sine * sine);
    any = true;
  }
  if (!any) {
    throw std::domain_error(
        fmt::format("the band {:.6g} .. {:.6g} Hz holds no line of a spectrum with lines every {:.6g} Hz up to "
                    "{:.6g} Hz: run longer, sample more finely, or widen it",
                    low, high, line, 0.5 / step));
  }
  return std::sqrt(sum) / static_cast<double>(n);
}

}  // namespace vehicle
