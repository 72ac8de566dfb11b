#pragma once

#include <memory>
#include <span>

#include "libvehicle/model/compiled_model.h"
#include "libvehicle/system/input.h"
#include "libvehicle/system/schedule.h"
#include "libvehicle/system/system.h"

namespace vehicle {

/// Force law of the suspensions between the Simbody rigid bodies.
enum class MbsLaw {
  kLinear,  // "mbs-linear": linear in the generalised coordinates, the same physics as the flat form
  kTrue,    // "mbs": true rotation and attachment geometry, gravity and preload
};

/// The vehicle as Simbody rigid bodies with one custom force element for all suspensions and contacts. State and
/// columns are those of every other form, measured from the loaded rest position.
///
/// Every body has the joints of its own motions: a slider for z, a pin for pitch. A wheelset that follows the rail is
/// an input of the force element, not a body; one with contact is a body on a slider, on the contact stiffness of
/// statics (of a Hertz contact: its tangent) in both laws. In kTrue springs stay vertical, each body takes a force
/// at its own attachment point; without heights that point is level with the centre of gravity.
///
/// linear() gives the matrices of kLinear, probed through Simbody by unit vectors, and nothing for kTrue.
/// One object serves one thread: its Simbody System and State are scratch space behind the const functions, and a
/// Simbody System must not be shared even with separate States. Set OPENBLAS_NUM_THREADS=1: its matrices are small.
class MbsForm : public System {
 public:
  /// Simbody's own Runge-Kutta-Merson over the schedule, a second, independent integrator. Steps end on samples and
  /// breakpoints, and after a breakpoint start from the right-hand limit. The observer may call output() and derivative().
  /// @param accuracy  local error on the scale of 1 m, 1 rad, 1 m/s, 1 rad/s; choose it 100 to 300 times tighter than
  ///                  the error wanted (paper's vehicle over 10 s: 1e-12 gives 4e-10 of each state's peak)
  /// @throws RunFailed on NaN or when the integrator gives up, with the time reached
  /// @throws std::invalid_argument unless 0 < accuracy < 1 and x0 and input have the form's sizes
  virtual Statistics runSimbody(const Input& input, const Schedule& schedule, double accuracy,
                                std::span<const double> x0, const Observer& observe) const = 0;
};

[[nodiscard]] std::unique_ptr<MbsForm> buildMbsForm(const CompiledModel& model, MbsLaw law);

}  // namespace vehicle
