#pragma once

#include <array>
#include <vector>

#include "libvehicle/matrix/matrix_form.h"
#include "libvehicle/model/compiled_model.h"

namespace vehicle {

/// Elongation of a suspension: sum of arm_i q_i - eta_channel (no such term where channel < 0).
struct Elongation {
  struct Term {
    int q = 0;         // coordinate
    double arm = 0.0;  // [-, m] not 0
  };
  std::array<Term, 4> terms{};  // z and pitch of the upper part, then of the lower one
  int count = 0;
  int channel = -1;  // wheelset that follows the rail
};

[[nodiscard]] Elongation elongationOf(const TopologySuspension& suspension, const Topology& topology);

/// Entries of K and C, or of B0 and B1, that stand at the same place.
struct SecondOrderEntry {
  int column = 0;
  double stiffness = 0.0;  // of K or B0
  double damping = 0.0;    // of C or B1
};

/// M q'' + C q' + K q = B0 eta + B1 eta', as far as it is not zero.
struct SparseSecondOrder {
  std::vector<double> mass;                         // (N) [kg, kg m^2]
  std::vector<std::vector<SecondOrderEntry>> own;   // rows of K and C (N), columns ascending
  std::vector<std::vector<SecondOrderEntry>> rail;  // rows of B0 and B1 (N), channels ascending
};

/// The matrices of a topology about its rest position (docs/theory/vertical.md), static-load terms of heights and
/// linearised contacts included; of a law its slopes there. Work and memory grow with the number of suspensions.
/// @param laws  (suspensions)
[[nodiscard]] SparseSecondOrder assemble(const Topology& topology, const Rest& rest,
                                         const std::vector<SuspensionLawPtr>& laws);

/// The same with its zeros.
[[nodiscard]] SecondOrder withZeros(const SparseSecondOrder& sparse, int channels);

}  // namespace vehicle
