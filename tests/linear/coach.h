#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "tests/support/paper_matrices.h"

// Systems whose modes are known, as matrices.
namespace vehicle::test {

inline std::vector<Channel> statesOf(const std::vector<std::string>& coordinates) {
  std::vector<Channel> states;
  for (const std::string& name : coordinates) states.push_back({name, "m"});
  for (const std::string& name : coordinates) states.push_back({name + "_rate", "m/s"});
  return states;
}

/// A of M q'' + C q' + K q = 0.
inline Eigen::MatrixXd stateMatrix(const Eigen::MatrixXd& M, const Eigen::MatrixXd& C, const Eigen::MatrixXd& K) {
  return stateSpaceOf(M, C, K, Eigen::MatrixXd::Zero(M.rows(), 1), Eigen::MatrixXd::Zero(M.rows(), 1)).A;
}

/// Numbers of a coach on two bogies in the plane; those of the Manchester benchmark.
/// Source: S. Iwnicki, Vehicle System Dynamics 30 (1998) 295-313.
struct CoachNumbers {
  double secondary_stiffness = 860e3;              // [N/m]
  double secondary_damping = 40e3;                 // [N s/m]
  double primary_stiffness[2] = {2440e3, 2440e3};  // [N/m] front, rear bogie
  double primary_damping = 8e3;                    // [N s/m]
  double bogie_inertia[2] = {1476, 1476};          // [kg m^2]
};

/// q = (zk, phi, z1, th1, z2, th2).
inline Eigen::MatrixXd coachMatrix(const CoachNumbers& numbers = {}) {
  using Row = Eigen::Matrix<double, 6, 1>;
  const double pivot = 9.5, axle = 1.28;
  const Row secondary[] = {{1, pivot, -1, 0, 0, 0}, {1, -pivot, 0, 0, -1, 0}};
  const Row primary[] = {{0, 0, 1, axle, 0, 0}, {0, 0, 1, -axle, 0, 0}, {0, 0, 0, 0, 1, axle}, {0, 0, 0, 0, 1, -axle}};
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(6, 6), C = K;
  for (const Row& r : secondary) {
    K += numbers.secondary_stiffness * r * r.transpose();
    C += numbers.secondary_damping * r * r.transpose();
  }
  for (int i = 0; i < 4; ++i) {
    K += numbers.primary_stiffness[i / 2] * primary[i] * primary[i].transpose();
    C += numbers.primary_damping * primary[i] * primary[i].transpose();
  }
  const Eigen::MatrixXd M =
      Row(32e3, 1.97e6, 2615, numbers.bogie_inertia[0], 2615, numbers.bogie_inertia[1]).asDiagonal();
  return stateMatrix(M, C, K);
}

inline std::vector<Channel> coachStates() {
  return statesOf(
      {"carbody.z", "carbody.pitch", "front_bogie.z", "front_bogie.pitch", "rear_bogie.z", "rear_bogie.pitch"});
}

}  // namespace vehicle::test
