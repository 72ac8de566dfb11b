#pragma once

namespace vehicle {

/// The rail at one distance.
struct RailPoint {
  double height = 0.0;     // z [m]
  double slope = 0.0;      // dz/ds [-]
  double curvature = 0.0;  // d^2z/ds^2 [1/m]
};

}  // namespace vehicle
