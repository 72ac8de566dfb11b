#pragma once

#include <memory>

#include <Eigen/Core>

#include "libvehicle/model/compiled_model.h"
#include "libvehicle/system/system.h"

namespace vehicle {

/// M q'' + C q' + K q = B0 eta + B1 eta'
struct SecondOrder {
  Eigen::MatrixXd M;   // [kg, kg m^2]       (N x N) diagonal
  Eigen::MatrixXd C;   // [N s/m and mixed]  (N x N)
  Eigen::MatrixXd K;   // [N/m and mixed]    (N x N), static-load terms of heights included
  Eigen::MatrixXd B0;  // [N/m and mixed]    (N x w)
  Eigen::MatrixXd B1;  // [N s/m and mixed]  (N x w)
};

/// The linear form of any topology: bodies, wheelsets that follow the rail or stand on a linear contact
/// spring, linear suspensions. Each spring-damper with row vector r adds c r^T r to K and b r^T r to C; under a
/// wheel on the rail c r^T goes to B0 and b r^T to B1. A Hertz contact is taken at its static load. Static loads at
/// heights add to the diagonal of K, which may then lose its definiteness. Only what is not zero is kept and computed,
/// so that a train of a hundred vehicles costs a hundred times one. Immutable: one object serves any number of threads.
class MatrixForm : public System {
 public:
  /// @throws std::invalid_argument beyond kMostDenseStates
  [[nodiscard]] virtual SecondOrder matrices() const = 0;
};

[[nodiscard]] std::unique_ptr<MatrixForm> buildMatrixForm(const CompiledModel& model);

}  // namespace vehicle
