#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
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

}  // namespace vehicle
