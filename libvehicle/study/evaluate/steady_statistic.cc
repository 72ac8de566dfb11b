#include "libvehicle/study/evaluate/steady_statistic.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

#include "libvehicle/ensemble/harmonic_orders.h"
#include "libvehicle/study/evaluate/column_statistic.h"

namespace vehicle {

namespace {

constexpr int kSamplesOfHighestOrder = 64;
constexpr int kFewestSamples = 4096;  // percentiles are as fine as the samples

}  // namespace

SteadyStatistic::SteadyStatistic(std::span<const double> angular_frequency)
    : angular_frequency_(angular_frequency.begin(), angular_frequency.end()) {
  const std::optional<std::vector<int>> orders = harmonicOrders(angular_frequency);
  if (!orders) return;
  const int highest = orders->empty() ? 1 : *std::max_element(orders->begin(), orders->end());
  const int samples = std::max(kFewestSamples, kSamplesOfHighestOrder * highest);
  values_.resize(static_cast<std::size_t>(samples));
  circle_ = circleOf(*orders, samples);
}

double SteadyStatistic::operator()(const Metric& metric, double mean,
                                   std::span<const std::complex<double>> amplitudes) {
  double sum = 0.0;
  switch (metric.statistic) {
    case Statistic::kMean:
      return mean;
    case Statistic::kRms:
      for (const auto& each : amplitudes) sum += 0.5 * std::norm(each);
      return std::sqrt(mean * mean + sum);
    case Statistic::kBand:
      if (metric.low == 0.0) sum = mean * mean;
      for (std::size_t f = 0; f < amplitudes.size(); ++f) {
        // A bound that is meant to be a harmonic's frequency is one, whatever the speed's conversion rounds to.
        constexpr double kSameFrequency = 1.0 + 1e-9;
        const double frequency = kSameFrequency * angular_frequency_[f] / (2.0 * std::numbers::pi);
        if (frequency >= metric.low && frequency < metric.high) sum += 0.5 * std::norm(amplitudes[f]);
      }
      return std::sqrt(sum);
    default:
      break;
  }
  sample(mean, amplitudes);
  switch (metric.statistic) {
    case Statistic::kMax:
      return highest(1.0);
    case Statistic::kMin:
      return -highest(-1.0);
    case Statistic::kPeak:
      return std::max(highest(1.0), highest(-1.0));
    case Statistic::kAbsolutePercentile:
      for (double& each : values_) each = std::abs(each);
      [[fallthrough]];
    default:
      return percentileOf(values_, metric.percent / 100.0);
  }
}

void SteadyStatistic::sample(double mean, std::span<const std::complex<double>> amplitudes) {
  if (values_.empty()) {
    throw std::domain_error("the " + std::to_string(angular_frequency_.size()) +
                            " harmonics have no common period, so extremes and percentiles have no closed form; leave "
                            "evaluation=\"steady_state\" out");
  }
  const double* circle = circle_.data();
  for (double& value : values_) {
    value = mean;
    for (const auto& each : amplitudes) {
      value += each.real() * circle[0] - each.imag() * circle[1];
      circle += 2;
    }
  }
}

// Largest sign x, by the parabola through the largest sample and its neighbours.
double SteadyStatistic::highest(double sign) const {
  const std::size_t n = values_.size();
  const auto top = static_cast<std::size_t>(
      std::max_element(values_.begin(), values_.end(), [sign](double a, double b) { return sign * a < sign * b; }) -
      values_.begin());
  const double here = sign * values_[top];
  const double before = sign * values_[(top + n - 1) % n];
  const double after = sign * values_[(top + 1) % n];
  const double bend = before - 2.0 * here + after;
  if (!(bend < 0.0)) return here;
  const double slope = 0.5 * (after - before);
  return here - 0.5 * slope * slope / bend;
}

SteadyStatistic& SteadyStatistics::of(const std::vector<double>& angular_frequency) {
  if (const auto found = kept_.find(angular_frequency); found != kept_.end()) return found->second;
  if (kept_.size() >= most_) kept_.clear();
  return kept_.try_emplace(angular_frequency, angular_frequency).first->second;
}

}  // namespace vehicle
