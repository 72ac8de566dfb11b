#pragma once

#include <memory>
#include <span>

#include "libvehicle/definition/vehicle.h"
#include "libvehicle/system/input.h"
#include "libvehicle/system/schedule.h"
#include "libvehicle/system/system.h"

namespace vehicle {

/// Force law of the suspensions between the Simbody rigid bodies.
enum class MbsLaw {
  kLinear,  // "mbs-linear": linear in the generalised coordinates, the same physics as the flat form
  kTrue,    // "mbs": true rotation and attachment geometry, gravity and preload
};

/// The vehicle as Simbody rigid bodies with one custom force element for all suspensions. State and columns
/// are those of every other form, measured from the loaded rest position. One object serves one thread: its
/// Simbody State is scratch space behind the const functions.
class MbsForm : public System {
 public:
  /// Simbody's own Runge-Kutta-Merson over the schedule, a second, independent integrator.
  /// @param accuracy  Simbody's weighted norm; choose it 100 to 300 times tighter than the error wanted
  /// @throws std::runtime_error on NaN or when the integrator gives up, with the time reached
  virtual Statistics runSimbody(const Input& input, const Schedule& schedule, double accuracy,
                                std::span<const double> x0, const Observer& observe) const = 0;
};

/// @throws InvalidInput if the vehicle contradicts itself
[[nodiscard]] std::unique_ptr<MbsForm> buildMbsForm(const Vehicle& vehicle, double gravity, MbsLaw law);

}  // namespace vehicle
