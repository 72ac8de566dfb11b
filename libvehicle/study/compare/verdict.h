#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "libvehicle/model/bound_study.h"

namespace vehicle {

/// What the objectives and limits of a study say of one row of metrics.
///
/// The worst of an objective's values over speeds and scenarios is the largest where it is minimised, the smallest
/// where it is maximised; a limit has to be kept by every one of them.
class Verdict {
 public:
  explicit Verdict(const BoundStudy& study);

  /// One value an objective, in its own sense: a maximised one is not negated. NaN where a value of it is missing.
  /// @param metrics  shape (metricColumns), of a design that is done; NaN where there is no value
  [[nodiscard]] std::vector<double> objectives(std::span<const double> metrics) const;
  /// The same with maximised ones negated, as pareto.h wants them.
  [[nodiscard]] std::vector<double> toMinimise(std::span<const double> metrics) const;

  /// The column in which the worst value of an objective stands, the first of equal ones; nothing where a value of it
  /// is missing.
  [[nodiscard]] std::optional<std::size_t> worstColumn(const BoundObjective& objective,
                                                       std::span<const double> metrics) const;

  /// How far each limit is overstepped at its worst case, in the metric's unit [SI]; 0 where it is kept, infinite where
  /// a value is missing: nobody knows that it is kept. Shape (limits).
  [[nodiscard]] std::vector<double> violations(std::span<const double> metrics) const;
  [[nodiscard]] bool keepsLimits(std::span<const double> metrics) const;

  /// Columns of a metric: one, or one a case.
  [[nodiscard]] std::span<const std::size_t> columnsOf(std::size_t metric) const { return columns_[metric]; }

 private:
  std::vector<BoundObjective> objectives_;
  std::vector<BoundLimit> limits_;
  std::vector<std::vector<std::size_t>> columns_;  // (metrics)
};

}  // namespace vehicle
