#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace vehicle {

// Designs compared by several objectives. Every objective is minimised here: whoever maximises hands in the negative.

/// Whether a is no worse in any objective and better in one.
[[nodiscard]] bool dominates(std::span<const double> a, std::span<const double> b);

/// The designs that no other dominates, gathered one by one: memory is that of the front alone. Of equal designs the
/// first one stays.
class ParetoFront {
 public:
  explicit ParetoFront(std::size_t objectives) : objectives_(objectives) {}

  struct Member {
    std::uint64_t design = 0;
    std::vector<double> objectives;
  };
  /// @param values  shape (objectives), finite; others are left out
  /// @returns whether the design is on the front as it is now
  bool add(std::uint64_t design, std::span<const double> values);
  /// In rising order of the first objective, then of the second ...
  [[nodiscard]] const std::vector<Member>& members() const { return members_; }

 private:
  std::size_t objectives_;
  std::vector<Member> members_;
};

/// Rank of each design: 0 for those that nothing dominates, 1 for those that only rank 0 dominates, and so on.
/// Source: Zhang et al., IEEE Trans. Evol. Comput. 19 (2015) 201 (sorted insertion, binary search among the fronts).
/// @param values  (designs x objectives), finite
[[nodiscard]] std::vector<std::size_t> paretoRanks(std::span<const double> values, std::size_t objectives);

/// How lonely each design of one front is: sum over the objectives of the gap between its neighbours over the whole
/// extent; infinity at the ends. Source: Deb et al., IEEE Trans. Evol. Comput. 6 (2002) 182.
/// @param values  (designs x objectives), finite
[[nodiscard]] std::vector<double> crowdingDistances(std::span<const double> values, std::size_t objectives);

/// Area between a front of two objectives and the reference point; designs beyond it count nothing.
/// @param values  (designs x 2), finite; dominated ones may be among them
[[nodiscard]] double hypervolume(std::span<const double> values, std::pair<double, double> reference);

}  // namespace vehicle
