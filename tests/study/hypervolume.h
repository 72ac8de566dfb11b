#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace vehicle {

/// Area between a front of two objectives and the reference point; designs beyond it count nothing.
/// @param values  (designs x 2), finite; dominated ones may be among them
inline double hypervolume(std::span<const double> values, std::pair<double, double> reference) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < values.size(); i += 2) {
    if (values[i] < reference.first && values[i + 1] < reference.second) points.emplace_back(values[i], values[i + 1]);
  }
  std::sort(points.begin(), points.end());
  double area = 0.0;
  double height = reference.second;
  for (const auto& [x, y] : points) {
    if (y >= height) continue;
    area += (reference.first - x) * (height - y);
    height = y;
  }
  return area;
}

}  // namespace vehicle
