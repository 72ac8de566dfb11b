#pragma once

#include <complex>
#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "libvehicle/definition/metric.h"

namespace vehicle {

/// Statistics of a periodic motion x(t) = mean + sum_f Re[ X_f e^(i w_f t) ].
///
/// r.m.s. and bands come from the amplitudes; what needs samples takes them over one common period of the harmonics,
/// extremes with a parabola through the largest and its neighbours.
class SteadyStatistic {
 public:
  /// @param angular_frequency  [rad/s] (F) > 0, distinct
  explicit SteadyStatistic(std::span<const double> angular_frequency);

  /// @param amplitudes  (F)
  /// @throws std::domain_error  where samples are needed and the harmonics have no common period
  [[nodiscard]] double operator()(const Metric& metric, double mean, std::span<const std::complex<double>> amplitudes);

 private:
  void sample(double mean, std::span<const std::complex<double>> amplitudes);
  [[nodiscard]] double highest(double sign) const;

  std::vector<double> angular_frequency_;
  std::vector<double> circle_;  // cos, sin of the orders, shape (samples x F x 2); empty without common period
  std::vector<double> values_;
};

/// The statistics of rails by their frequencies, each prepared once. Keeps workspace: one object a thread.
class SteadyStatistics {
 public:
  /// @param most  kept at a time, >= 1: designs may bring frequencies of their own
  explicit SteadyStatistics(std::size_t most) : most_(most) {}
  /// @param angular_frequency  [rad/s] as of SteadyStatistic   @returns valid until the next call
  [[nodiscard]] SteadyStatistic& of(const std::vector<double>& angular_frequency);

 private:
  std::size_t most_;
  std::map<std::vector<double>, SteadyStatistic> kept_;
};

}  // namespace vehicle
