#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "libvehicle/definition/study.h"

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

/// How much comes from two factors together, beyond what either does alone.
struct PairIndex {
  std::size_t i = 0;
  std::size_t j = 0;  // > i
  Estimate second;    // V(E(y | x_i, x_j)) / V(y) - first_i - first_j
};

struct SensitivityResult {
  std::vector<SensitivityIndex> indices;  // (factors); empty if fewer than 2 blocks are whole or y does not vary
  std::vector<PairIndex> pairs;           // (factors (factors - 1) / 2) of second order, in the order of i, then of j
  double mean = 0.0;                      // of y over A and B
  double variance = 0.0;
  std::size_t blocks = 0;    // that were whole
  std::size_t left_out = 0;  // blocks in which a design has no value
};

struct SensitivityChoice {
  SecondOrder order = SecondOrder::kNo;
  std::size_t repetitions = 200;  // of the bootstrap; 0: intervals of no width
  std::uint64_t seed = 1;
};

/// Sobol indices of a metric from the designs of a Saltelli plan.
///
/// With y_A, y_B, y_ABi the values at the points A, B, and A with coordinate i of B, and y centred on its mean:
///     first_i = mean(y_B (y_ABi - y_A)) / V,   total_i = mean((y_A - y_ABi)^2) / (2 V),   V the variance of A and B.
/// With second order there is also y_BAi, at B with coordinate i of A. Both indices are then the means of the above and
/// of the same with A and B exchanged, and
///     second_ij = mean(y_BAi y_ABj + y_BAj y_ABi - 2 y_A y_B) / (2 V) - first_i - first_j:
/// the two points of either product have coordinates i and j in common and no other.
/// The error falls as 1/sqrt(blocks) for random points, about as 1/blocks for the Sobol points of the plan; the
/// intervals come from drawing blocks again with replacement and tell the first of the two.
/// Source: Saltelli et al., Computer Physics Communications 181 (2010) 259, Table 2 (b) and (f); the latter by Jansen
/// (1999). Second order: A. Saltelli, Computer Physics Communications 145 (2002) 280, theorem 2.
/// @param values  (blocks x (factors + 2)): y_A, y_B, y_AB1 ..; with second order (blocks x (2 factors + 2)), y_BA1 ..
///                last; NaN for a design without a value
/// @throws std::invalid_argument if values are no whole number of blocks or there is no factor
[[nodiscard]] SensitivityResult sensitivityOf(std::span<const double> values, std::size_t factors,
                                              const SensitivityChoice& choice = {});

}  // namespace vehicle
