#pragma once

#include "libvehicle/law/suspension_law.h"

namespace vehicle {

/// A linear spring and damper in parallel:
///     f = c d + b v,   stored c d^2 / 2,   dissipated b v^2
class LinearSpringDamper final : public SuspensionLaw {
 public:
  /// @param stiffness  c [N/m] >= 0   @param damping  b [N s/m] >= 0
  LinearSpringDamper(double stiffness, double damping) : stiffness_(stiffness), damping_(damping) {}

  [[nodiscard]] bool isLinear() const override { return true; }
  [[nodiscard]] double force(const LawPoint& at) const override;
  [[nodiscard]] LawSlopes slopes(const LawPoint& at) const override;
  [[nodiscard]] double storedEnergy(const LawPoint& at) const override;
  [[nodiscard]] double dissipatedPower(const LawPoint& at) const override;

 private:
  double stiffness_;
  double damping_;
};

}  // namespace vehicle
