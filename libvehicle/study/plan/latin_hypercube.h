#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "libvehicle/study/plan/keyed_permutation.h"

namespace vehicle {

/// A Latin hypercube of n points: in every dimension each of the n equal strata of [0, 1) holds exactly one point,
/// at a random place in it. Point i follows from the seed and i alone.
/// Source: McKay, Beckman, Conover, Technometrics 21 (1979) 239.
class LatinHypercube {
 public:
  /// @param size  n, >= 1
  LatinHypercube(std::uint64_t size, std::size_t dimensions, std::uint64_t seed);

  /// @param index  < n
  /// @param point  shape (dimensions), each 0 <= u < 1
  void point(std::uint64_t index, std::span<double> point) const;

 private:
  std::uint64_t size_;
  std::uint64_t seed_;
  std::vector<KeyedPermutation> strata_;  // (dimensions)
};

}  // namespace vehicle
