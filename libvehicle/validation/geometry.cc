#include "libvehicle/validation/geometry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vehicle {
namespace {

/// One end of a suspension on a body.
struct End {
  double arm = 0.0;     // |a| [m]
  double height = 0.0;  // |h| [m]
  double pitch = 0.0;   // max |phi| [rad]
  double rate = 0.0;    // max |phi'| [rad/s]
  int z_index = -1;
  int pitch_index = -1;
};

End endOf(const Topology& topology, const MotionSize& motion, int body_index, double arm, double height) {
  const TopologyBody& body = topology.bodies[static_cast<std::size_t>(body_index)];
  End end{std::abs(arm), std::abs(height), 0.0, 0.0, body.z_index, body.pitch_index};
  if (body.pitch_index >= 0) {
    end.pitch = motion.state(body.pitch_index);
    end.rate = motion.state(topology.coordinates + body.pitch_index);
  }
  return end;
}

double heightError(const End& end) {
  return end.arm * std::pow(end.pitch, 3) / 6.0 + end.height * end.pitch * end.pitch / 2.0;
}

double rateError(const End& end) { return (end.arm * end.pitch * end.pitch / 2.0 + end.height * end.pitch) * end.rate; }

}  // namespace

GeometryDisturbance geometryDisturbance(const Topology& topology, const Rest& rest, const MotionSize& motion) {
  const Eigen::Index springs = static_cast<Eigen::Index>(topology.suspensions.size());
  GeometryDisturbance made{Eigen::VectorXd::Zero(topology.coordinates), Eigen::VectorXd::Zero(springs),
                           Eigen::VectorXd::Zero(springs)};
  Eigen::VectorXd static_moment = Eigen::VectorXd::Zero(topology.coordinates);
  for (Eigen::Index s = 0; s < springs; ++s) {
    const TopologySuspension& suspension = topology.suspensions[static_cast<std::size_t>(s)];
    const double load = rest.suspension_load[static_cast<std::size_t>(s)];
    End ends[2] = {endOf(topology, motion, suspension.upper, suspension.arm_upper, suspension.height_upper), {}};
    if (suspension.lower_body >= 0) {
      ends[1] = endOf(topology, motion, suspension.lower_body, suspension.arm_lower, suspension.height_lower);
    } else {
      ends[1].z_index = topology.wheelsets[static_cast<std::size_t>(suspension.lower_wheelset)].z_index;
    }
    const double deflection_error = heightError(ends[0]) + heightError(ends[1]);
    const double force_error =
        suspension.stiffness * deflection_error + suspension.damping * (rateError(ends[0]) + rateError(ends[1]));
    const double force = motion.suspension_force(s);
    made.deflection(s) = deflection_error;
    made.suspension_force(s) = force_error;
    for (const End& end : ends) {
      if (end.z_index >= 0) made.force(end.z_index) += force_error;
      if (end.pitch_index < 0) continue;
      made.force(end.pitch_index) += end.arm * force_error +
                                     force * (end.arm * end.pitch * end.pitch / 2.0 + end.height * end.pitch) +
                                     std::abs(load) * end.height * std::pow(end.pitch, 3) / 6.0;
    }
    if (ends[0].pitch_index >= 0) static_moment(ends[0].pitch_index) += load * suspension.arm_upper;
    if (ends[1].pitch_index >= 0) static_moment(ends[1].pitch_index) -= load * suspension.arm_lower;
  }
  for (const TopologyBody& body : topology.bodies) {
    if (body.pitch_index < 0) continue;
    const double pitch = motion.state(body.pitch_index);
    made.force(body.pitch_index) += std::abs(static_moment(body.pitch_index)) * pitch * pitch / 2.0;
  }
  return made;
}

}  // namespace vehicle
