#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "libvehicle/system/system.h"

namespace vehicle {

/// The matrices of equations without a constant term: the answer to a unit vector is a column of them, exactly.
[[nodiscard]] inline StateSpace unitResponses(const System& form) {
  StateSpace matrices{Eigen::MatrixXd(form.size(), form.size()), Eigen::MatrixXd(form.size(), 2 * form.channels())};
  const auto n = static_cast<std::size_t>(form.size());
  const auto w = 2 * static_cast<std::size_t>(form.channels());
  std::vector<double> unit(std::max(n, w), 0.0);
  const std::vector<double> zero(unit.size(), 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    unit[i] = 1.0;
    form.derivative(unit, zero, {matrices.A.col(static_cast<Eigen::Index>(i)).data(), n});
    unit[i] = 0.0;
  }
  for (std::size_t i = 0; i < w; ++i) {
    unit[i] = 1.0;
    form.derivative(zero, unit, {matrices.B.col(static_cast<Eigen::Index>(i)).data(), n});
    unit[i] = 0.0;
  }
  return matrices;
}

}  // namespace vehicle
