#pragma once

#include <complex>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "libvehicle/system/system.h"

namespace vehicle {

/// One mode of x' = A x.
struct Mode {
  std::complex<double> eigenvalue;  // [1/s]; of a conjugate pair the one with positive imaginary part
  double frequency = 0.0;           // [Hz] undamped, |lambda| / 2 pi; of a real root too
  double damping_ratio = 0.0;       // [-] -Re(lambda) / |lambda|; 1 for a decaying real root
  int multiplicity = 1;             // how many modes share this eigenvalue within rounding
  Eigen::VectorXcd shape;           // (N) of q, the largest entry 1
  std::string name;                 // e.g. "carbody bounce", "front_bogie pitch", "bogies bounce in phase"
};

/// Modes of a linear system, sorted by |lambda|. Source: any text on linear vibration; repeated eigenvalues are
/// found by clustering within the perturbation bound of the eigenvalue solver.
/// @throws std::invalid_argument if system.linear() is empty
[[nodiscard]] std::vector<Mode> modesOf(const System& system);

}  // namespace vehicle
