#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vehicle {

/// How far a metric follows its factors along straight lines, for designs of any plan: correlation and standardised
/// regression coefficients. Designs are added one by one and none is kept.
///
/// Means and co-moments are updated as in Welford's method, which keeps its digits where sums of squares would not.
/// Source: T. F. Chan, G. H. Golub, R. J. LeVeque, The American Statistician 37 (1983) 242.
class Regression {
 public:
  explicit Regression(std::size_t factors);

  /// @param x  shape (factors); designs with a value that is not finite are left out
  void add(std::span<const double> x, double y);

  [[nodiscard]] std::uint64_t designs() const { return count_; }
  /// Pearson's correlation of each factor with y, -1 .. 1; 0 for what does not vary. Shape (factors).
  [[nodiscard]] std::vector<double> correlations() const;

  struct Fit {
    std::vector<double> coefficients;  // (factors) b_i s_i / s_y of y = a + sum b_i x_i
    double explained = 0.0;            // R^2: share of the variance of y that the straight lines explain, 0 .. 1
  };
  /// Nothing where factors vary together or not at all, or there are too few designs.
  [[nodiscard]] std::optional<Fit> fit() const;

 private:
  [[nodiscard]] bool varies(std::size_t i) const;
  [[nodiscard]] double moment(std::size_t i, std::size_t j) const { return moments_[i * means_.size() + j]; }

  std::uint64_t count_ = 0;
  std::vector<double> means_;    // (factors + 1), y last
  std::vector<double> moments_;  // (factors + 1)^2, sums of products of deviations
  std::vector<double> step_;     // (factors + 1), scratch
};

}  // namespace vehicle
