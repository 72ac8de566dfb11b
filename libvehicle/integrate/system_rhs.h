#pragma once

#include <span>

#include "libvehicle/system/system.h"

namespace vehicle {

/// Any System as the right-hand side of a stepper: one virtual call an evaluation. Looks at the system, which must
/// outlive it.
class SystemRhs {
 public:
  explicit SystemRhs(const System& system)
      : system_(&system),
        states_(static_cast<std::size_t>(system.size())),
        inputs_(2 * static_cast<std::size_t>(system.channels())) {}

  void operator()(const double* x, const double* u, double* dx) const {
    system_->derivative({x, states_}, {u, inputs_}, {dx, states_});
  }

 private:
  const System* system_;
  std::size_t states_;
  std::size_t inputs_;
};

}  // namespace vehicle
