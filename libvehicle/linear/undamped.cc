#include "libvehicle/linear/undamped.h"

#include <algorithm>

namespace vehicle {

std::vector<UndampedMode> undampedModesOf(const Eigen::MatrixXd& A, const std::vector<Channel>& states) {
  const Eigen::Index N = A.rows() / 2;
  const auto damped_by = [&](double share) {
    Eigen::MatrixXd part = A;
    part.bottomRightCorner(N, N) *= share;
    return part;
  };
  const ModeFollower follower(damped_by(0.0), states);
  const std::vector<FollowedMode> ends = follower.follow(damped_by);
  std::vector<UndampedMode> list;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Mode& root = follower.modes()[i].roots.front();
    list.push_back({root.eigenvalue.imag() > 0.0 ? root.frequency : 0.0, ends[i]});
  }
  return list;
}

std::optional<double> undampedFrequencyOf(std::span<const Mode> roots, std::span<const UndampedMode> undamped) {
  // The roots are those of modesOf() in both places, to the bit; of modes that coincide any is as good.
  for (const UndampedMode& each : undamped) {
    const bool has_all = std::all_of(roots.begin(), roots.end(), [&](const Mode& root) {
      return std::any_of(each.damped.roots.begin(), each.damped.roots.end(),
                         [&](const Mode& other) { return other.eigenvalue == root.eigenvalue; });
    });
    if (!has_all || roots.empty()) continue;
    if (each.frequency > 0.0) return each.frequency;
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace vehicle
