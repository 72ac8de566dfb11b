#pragma once

#include <span>

#include <Eigen/Core>

#include "libvehicle/model/rest.h"
#include "libvehicle/model/topology.h"

namespace vehicle {

/// How large the motion of a run was; all entries >= 0.
struct MotionSize {
  Eigen::VectorXd state;             // (n)       max |x_j| over the run
  Eigen::VectorXd input;             // (3 w)     max |eta|, |eta'|, |eta''| per wheelset
  Eigen::VectorXd output;            // (outputs) max |y_i|, columns of a result after `time`
  Eigen::VectorXd suspension_force;  // (suspensions) [N] max |dynamic force|
};

/// What true rotation and attachment geometry add to the linear equations, as bounds.
struct GeometryDisturbance {
  Eigen::VectorXd force;             // (N) [N, N m] on each coordinate
  Eigen::VectorXd deflection;        // (suspensions) [m]
  Eigen::VectorXd suspension_force;  // (suspensions) [N]
};

/// The terms that the linear forms leave out, each by its largest value over the run. A suspension sits at
/// (a, h) from the centre of gravity of a body that pitches by phi; F0 is its static load, F its dynamic force.
///
///   height of the attachment    a sin(phi) + h (cos(phi) - 1)  instead of  a phi:   a phi^3/6 + h phi^2/2
///   its rate                                                                        (a phi^2/2 + h phi) phi'
///   force                       e_F = k e_d + c e_d',  summed over both ends
///   moment                      arm a cos(phi) - h sin(phi) instead of a; F0 h phi is in the linear forms too:
///                               a e_F + F (a phi^2/2 + h phi) + F0 h phi^3/6,  and  |sum F0 a| phi^2/2 per body
///
/// Without heights everything shrinks with amplitude^2 relative to the motion, with heights with amplitude^1
/// (h/a phi), as docs/theory/validation.md shows.
[[nodiscard]] GeometryDisturbance geometryDisturbance(const Topology& topology, const Rest& rest,
                                                      const MotionSize& motion);

}  // namespace vehicle
