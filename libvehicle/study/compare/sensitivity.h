#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vehicle {

/// A number with the interval in which 95 % of its bootstrap repetitions lie.
struct Estimate {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// How much of a metric's variance comes from one factor.
struct SensitivityIndex {
  Estimate first;  // alone:               V(E(y | x_i)) / V(y)
  Estimate total;  // with all its company: E(V(y | all but x_i)) / V(y)
};

struct SensitivityResult {
  std::vector<SensitivityIndex> indices;  // (factors); empty if fewer than 2 blocks are whole or y does not vary
  double mean = 0.0;                      // of y over A and B
  double variance = 0.0;
  std::size_t blocks = 0;    // that were whole
  std::size_t left_out = 0;  // blocks with a failed design
};

/// Sobol indices of a metric from the designs of a Saltelli plan.
///
/// With y_A, y_B, y_ABi the values at the points A, B, and A with coordinate i of B, and y centred on its mean:
///     first_i = mean(y_B (y_ABi - y_A)) / V,   total_i = mean((y_A - y_ABi)^2) / (2 V),   V the variance of A and B.
/// The error falls as 1/sqrt(blocks) for random points, about as 1/blocks for the Sobol points of the plan; the
/// intervals come from drawing blocks again with replacement and tell the first of the two.
/// Source: Saltelli et al., Computer Physics Communications 181 (2010) 259, Table 2 (b) and (f); the latter by Jansen
/// (1999).
/// @param values       (blocks x (factors + 2)): y_A, y_B, y_AB1 ..; NaN for a failed design
/// @param repetitions  of the bootstrap; 0: intervals of no width
/// @throws std::invalid_argument if values are no whole number of blocks or there is no factor
[[nodiscard]] SensitivityResult sensitivityOf(std::span<const double> values, std::size_t factors,
                                              std::size_t repetitions = 200, std::uint64_t seed = 1);

}  // namespace vehicle
