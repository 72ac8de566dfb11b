#include "libvehicle/ensemble/harmonic_orders.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vehicle {

std::optional<std::vector<int>> harmonicOrders(std::span<const double> angular_frequency) {
  constexpr double kSame = 1e-9;
  if (angular_frequency.empty()) return std::vector<int>{};
  const double lowest = *std::min_element(angular_frequency.begin(), angular_frequency.end());
  for (int divisor = 1; divisor <= kMostOrder; ++divisor) {
    std::vector<int> orders;
    for (const double w : angular_frequency) {
      const double order = w / lowest * divisor;
      const double nearest = std::round(order);
      if (!(nearest <= kMostOrder) || std::abs(order - nearest) > kSame * nearest) break;
      orders.push_back(static_cast<int>(nearest));
    }
    if (orders.size() == angular_frequency.size()) return orders;
  }
  return std::nullopt;
}

std::vector<double> circleOf(std::span<const int> orders, int samples, std::size_t zeros_before) {
  std::vector<double> circle;
  circle.reserve(static_cast<std::size_t>(samples) * (zeros_before + orders.size()) * 2);
  for (int n = 0; n < samples; ++n) {
    circle.insert(circle.end(), 2 * zeros_before, 0.0);
    for (const int order : orders) {
      // Reduced first, so that the angle is as good at the end of the period as at its begin.
      const double turn = static_cast<double>((static_cast<long>(order) * n) % samples) / samples;
      circle.push_back(std::cos(2.0 * std::numbers::pi * turn));
      circle.push_back(std::sin(2.0 * std::numbers::pi * turn));
    }
  }
  return circle;
}

}  // namespace vehicle
