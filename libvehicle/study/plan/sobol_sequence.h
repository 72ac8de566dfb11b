#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vehicle {

/// Sobol's low-discrepancy sequence in [0, 1)^d with direction numbers of Boost.Random (Joe and Kuo), any point of it
/// at the cost of one: point i is the exclusive or of the direction numbers at the ones of i's Gray code.
///
/// The point at 0 counts too: without it blocks of 2^m points lose their balance (Owen 2020, On dropping the first
/// Sobol' point). A seed other than 0 shifts all points by one random vector, digit by digit, which keeps the balance
/// and moves the first point off the corner.
/// Source: Antonov, Saleev, USSR Comput. Maths. Math. Phys. 19 (1980) 252.
class SobolSequence {
 public:
  static constexpr std::size_t kMostDimensions = 3667;
  static constexpr unsigned kBits = 40;  // of the number of a point

  /// @param dimensions  1 .. kMostDimensions
  SobolSequence(std::size_t dimensions, std::uint64_t seed);

  [[nodiscard]] std::size_t dimensions() const { return shift_.size(); }
  /// @param index  < 2^kBits
  /// @param point  shape (dimensions), each 0 <= u < 1
  void point(std::uint64_t index, std::span<double> point) const;

 private:
  std::vector<std::uint64_t> directions_;  // (kBits x dimensions)
  std::vector<std::uint64_t> shift_;       // (dimensions)
};

}  // namespace vehicle
