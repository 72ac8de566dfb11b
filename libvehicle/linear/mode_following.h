#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "libvehicle/linear/modes.h"

namespace vehicle {

/// State matrix A(t) (2N x 2N) of a system on its way from one to another, 0 <= t <= 1. Asked at any t, in any order.
using MatrixPath = std::function<Eigen::MatrixXd(double t)>;

/// One degree of freedom's worth of motion: a pair of roots, or both real roots into which its damping has split the
/// pair.
struct WholeMode {
  std::vector<std::string> names;  // the first without ", aperiodic"; then what its roots are called one by one
  std::vector<Mode> roots;         // the pair as one, or real roots by their size
};

/// What has become of a mode.
struct FollowedMode {
  enum class Fate {
    kOscillates,  // roots: the pair
    kAperiodic,   // roots: the real ones; one where both coincide or only one is known
    kLost,        // roots: none; reason says why
  };
  Fate fate = Fate::kLost;
  std::vector<Mode> roots;  // of modesOf() there
  std::string reason;

  /// [Hz] |lambda| / 2 pi and |Im lambda| / 2 pi; nothing unless it oscillates.
  [[nodiscard]] std::optional<double> frequency() const;
  [[nodiscard]] std::optional<double> dampedFrequency() const;
  /// [-] -(l1 + l2) / (2 sqrt(l1 l2)) of its two roots: -Re(lambda) / |lambda| of a pair, 1 or more where two real
  /// roots decay; nothing where one of them grows, is 0, or is not known.
  [[nodiscard]] std::optional<double> dampingRatio() const;
  /// Why there is no frequency, for messages; "" if there is.
  [[nodiscard]] std::string whyNoFrequency() const;
};

/// Follows the modes of one system to another, so that a name means one mode wherever it is asked for.
///
/// A mode is a pair of roots with their invariant subspace, which depends smoothly on the matrix as long as no other
/// root meets them: also where the pair becomes two real roots (critical damping) and back. Along a path the steps are
/// halved until each of them, and its two halves, say the same of every mode without doubt (branches.h). So identity
/// is continuity along the path:
///   - Modes that are not coupled pass each other and keep their shapes; less than 1e-6 of the frequency is no coupling.
///   - Coupled modes whose frequencies approach turn away from each other (veering): each keeps its branch, along which
///     eigenvalue and shape are continuous, and beyond the branch has the other one's shape.
///   - Modes that coincide, as those of equal bogies, are followed by their common subspace. Where they part, shapes
///     choose the branch, and order where shapes do not.
///   - Two modes that meet in a double root with one shape are lost: beyond it nothing distinguishes them.
/// The result depends on base and path alone. Cost: two Schur decompositions a path for a clear one, some tens where
/// modes meet.
class ModeFollower {
 public:
  /// @param A       (2N x 2N) of the base, state (q, q')   @param states  2N channels, as for modesOf()
  /// @throws as modesOf()
  ModeFollower(const Eigen::MatrixXd& A, const std::vector<Channel>& states);

  /// Modes of the base: pairs, and real roots two by two as damping has parted them.
  [[nodiscard]] const std::vector<WholeMode>& modes() const { return modes_; }
  /// The mode of that name: "carbody pitch", or "carbody pitch, aperiodic (2)" of one of its roots.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;

  /// @param path  path(0) is the base
  /// @return (modes) at path(1)
  [[nodiscard]] std::vector<FollowedMode> follow(const MatrixPath& path) const;
  /// The same at several places of one way.
  /// @param stops  0 < t <= 1, rising
  /// @return (stops x modes)
  [[nodiscard]] std::vector<std::vector<FollowedMode>> follow(const MatrixPath& path,
                                                              std::span<const double> stops) const;

 private:
  struct Start;
  std::vector<Channel> states_;
  Eigen::VectorXd units_;
  std::vector<WholeMode> modes_;
  std::shared_ptr<const Start> start_;
};

}  // namespace vehicle
