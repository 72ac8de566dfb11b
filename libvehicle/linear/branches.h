#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "libvehicle/linear/root_groups.h"

namespace vehicle {

// Roots of one matrix recognised among those of another by their shapes. Private to this room.

/// One or two roots of a mode on their way along a path: a conjugate pair or a real root. Branches whose roots coincide
/// share the subspace of their group, each with a part of its own.
struct Branch {
  std::vector<int> owners;  // (roots) the mode that each belongs to; kNobody: no longer known. Of two real roots that
                            // have met the left one's is first
  std::complex<double> value;  // of a pair the one with Im >= 0
  std::size_t group = 0;       // of the matrix that it stands at
  Eigen::MatrixXcd right;      // (n x roots)
  Eigen::MatrixXcd left;       // (roots x n)
  [[nodiscard]] Eigen::Index size() const { return right.cols(); }
};
inline constexpr int kNobody = -1;

/// What becomes of branches without a clear partner.
enum class Doubt {
  kRefuse,  // nothing is returned
  kOrder,   // the same, but roots that coincided leave in their order where their shapes do not say more
  kLose,    // as kOrder; other such branches are nobody's from there on
};

/// The branches at the next matrix.
///
/// What a branch b and a group h share is tr(P_b P_h), P the projectors on their subspaces along all others: each sum
/// over b or h is a number of roots, whatever the units of the state. For undamped modes it is the modal assurance
/// criterion weighted with the masses. A branch is clear if it shares with one group alone, or if what it shares with
/// stays apart from the rest and can only be read in one way: a pair that has become two real roots, or two real roots
/// that have become a pair.
///
/// Two modes whose roots pass each other between the matrices keep their shapes where they are not coupled, and
/// exchange them where they are. From what they share, and their distances d0 and d1, follows the coupling
/// kappa = sqrt(share) / |1/d0 - 1/d1|; the step is refused unless the straight line from d0 to d1 stays 4 kappa away
/// from 0, or kappa is nothing.
/// Source: R. J. Allemang, D. L. Brown, Proc. 1st IMAC (1982) 110 (MAC); M. S. Eldred, V. B. Venkayya, W. J. Anderson,
/// AIAA Journal 33 (1995) 1292 (left and right vectors for modes of damped and nonconservative systems).
/// @param branches  n roots in all   @param groups  of the next matrix, n roots in all
[[nodiscard]] std::optional<std::vector<Branch>> advance(const std::vector<Branch>& branches,
                                                         const std::vector<RootGroup>& groups, Doubt doubt);

/// Whether the same owners have come to the same groups.
[[nodiscard]] bool sameOwners(const std::vector<Branch>& a, const std::vector<Branch>& b);

}  // namespace vehicle
