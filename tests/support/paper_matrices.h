#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Core>
#include <Eigen/LU>

#include "libvehicle/system/input.h"
#include "libvehicle/system/system.h"

// The paper's vehicle as bare matrices and its rail as bare segments, typed from the consistent equations (2)-(6) and
// not built by any form of the library: numerics are tested on the case that matters without a room that they may
// not see.
namespace vehicle::test {

/// M, C, K, B0, B1 of q = (zk, phi, z1, z2), eta = (eta1..eta4), as A and B of x = (q, q').
inline StateSpace stateSpaceOf(const Eigen::MatrixXd& M, const Eigen::MatrixXd& C, const Eigen::MatrixXd& K,
                               const Eigen::MatrixXd& B0, const Eigen::MatrixXd& B1) {
  const Eigen::Index N = M.rows();
  const Eigen::MatrixXd inverse = M.inverse();
  StateSpace system;
  system.A = Eigen::MatrixXd::Zero(2 * N, 2 * N);
  system.A.topRightCorner(N, N).setIdentity();
  system.A.bottomLeftCorner(N, N) = -inverse * K;
  system.A.bottomRightCorner(N, N) = -inverse * C;
  system.B = Eigen::MatrixXd::Zero(2 * N, 2 * B0.cols());
  system.B.bottomLeftCorner(N, B0.cols()) = inverse * B0;
  system.B.bottomRightCorner(N, B0.cols()) = inverse * B1;
  return system;
}

/// @param Jk  [kg m^2]
inline StateSpace paperMatrices(double Jk = 70e3) {
  constexpr double mk = 57e3, mb = 9e3, ak = 3.725, cb = 3040e3, bb = 30e3, ck = 2660e3, bk = 100e3;
  const auto assembled = [](double secondary, double primary) {
    Eigen::Matrix4d matrix;
    // clang-format off
    matrix << 2 * secondary,                   0.0,         -secondary,             -secondary,
              0.0,         2 * ak * ak * secondary,    -ak * secondary,         ak * secondary,
              -secondary,          -ak * secondary, secondary + 2 * primary,               0.0,
              -secondary,           ak * secondary,                0.0, secondary + 2 * primary;
    // clang-format on
    return matrix;
  };
  const auto input = [](double primary) {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    matrix(2, 0) = matrix(2, 1) = matrix(3, 2) = matrix(3, 3) = primary;
    return matrix;
  };
  const Eigen::Matrix4d M = Eigen::Vector4d(mk, Jk, mb, mb).asDiagonal();
  return stateSpaceOf(M, assembled(bk, bb), assembled(ck, cb), input(cb), input(bb));
}

inline std::vector<Channel> paperStates() {
  return {{"carbody.z", "m"},          {"carbody.pitch", "rad"},          {"front_bogie.z", "m"},
          {"rear_bogie.z", "m"},       {"carbody.vz", "m/s"},             {"carbody.pitch_rate", "rad/s"},
          {"front_bogie.vz", "m/s"},   {"rear_bogie.vz", "m/s"}};
}

inline constexpr double kPaperDelays[4] = {0.0, 0.15, 0.3725, 0.5225};  // [s] at 20 m/s

/// The segment from `begin` on, in which the first `rolling` wheels are on the profile (6) and the others on flat rail.
inline InputSegment paperSegment(double begin, double end, int rolling, double speed = 20.0) {
  InputSegment segment;
  segment.begin = begin;
  segment.end = end;
  const double w = 2.0 * std::numbers::pi * speed / 25.0;
  segment.angular_frequency = {w, 3.0 * w};
  segment.polynomial.assign(16, 0.0);
  for (int wheel = 0; wheel < 4; ++wheel) {
    const double since = begin - kPaperDelays[wheel] * 20.0 / speed;
    for (const auto& [frequency, amplitude] : {std::pair{w, 5e-3}, std::pair{3.0 * w, 2e-3}}) {
      const double on = wheel < rolling ? amplitude : 0.0;
      segment.cosine.push_back(on * std::sin(frequency * since));
      segment.sine.push_back(on * std::cos(frequency * since));
    }
  }
  return segment;
}

inline Input paperExtended(double duration = 10.0) { return Input(4, {paperSegment(0.0, duration, 4)}); }

inline Input paperOnset(double duration = 10.0) {
  return Input(4, {paperSegment(0.0, 0.15, 1), paperSegment(0.15, 0.3725, 2), paperSegment(0.3725, 0.5225, 3),
                   paperSegment(0.5225, duration, 4)});
}

}  // namespace vehicle::test
