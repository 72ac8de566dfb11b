#pragma once

#include <array>
#include <span>
#include <vector>

#include "libvehicle/flat/flat_layout.h"
#include "libvehicle/flat/flat_model.h"
#include "libvehicle/flat/flat_statics.h"
#include "libvehicle/model/compiled_model.h"

namespace vehicle {

/// The columns that one flat vehicle fills, alone or in a train: its bodies, suspensions, wheelsets, measuring points.
class FlatOutput {
 public:
  /// @param model   of the vehicle or of the whole train, where the layout's parts stand
  FlatOutput(const CompiledModel& model, const FlatLayout& layout, const FlatParameters& parameters,
             const FlatLoads& loads);

  /// @param x   (8) zk, phi, z1, z2, zk', phi', z1', z2'   @param dx  (8) its derivative
  /// @param u   (12) heights, rates and accelerations of the rail under the wheels 1 to 4
  /// @param y   all columns of the result
  void write(const double* x, const double* dx, const double* u, std::span<double> y) const;

 private:
  /// A measuring point: z + arm phi of its body.
  struct Point {
    std::array<int, 3> columns{};
    std::size_t inner = 0;  // inner coordinate of the body's z: 0 carbody, 2 front, 3 rear bogie
    double arm = 0.0;       // [m] 0 on a bogie, which does not pitch
  };

  FlatParameters v_;
  std::array<double, 4> wheel_load_;       // [N] static
  std::array<double, 4> wheelset_mass_{};  // [kg]
  // Columns of the result, -1 never: the layout has all of these parts.
  std::array<int, 6> carbody_{};                   // z, pitch, their rates, their accelerations
  std::array<std::array<int, 3>, 2> bogie_{};      // z, its rate, its acceleration
  std::array<std::array<int, 2>, 2> secondary_{};  // deflection, force
  std::array<std::array<int, 2>, 4> primary_{};    // deflection, force
  std::array<std::array<int, 2>, 4> wheelset_{};   // rail_z, load
  std::vector<Point> points_;
};

}  // namespace vehicle
