#pragma once

#include <memory>

#include "libvehicle/integrate/integrator.h"
#include "libvehicle/model/compiled_model.h"
#include "libvehicle/system/run_problem.h"

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
  /// Simbody's own Runge-Kutta-Merson, a second, independent integrator (simbody_steps.h). An observer may call output()
  /// and derivative() of this form.
  /// @param problem   of this form
  /// @param accuracy  local error on the scale of 1 m, 1 rad, 1 m/s, 1 rad/s; choose it 100 to 300 times tighter than
  ///                  the error wanted (paper's vehicle over 10 s: 1e-12 gives 4e-10 of each state's peak)
  /// @throws std::invalid_argument unless 0 < accuracy < 1 and the input has the form's size
  [[nodiscard]] virtual std::unique_ptr<Integrator> bySimbody(const RunProblem& problem, double accuracy) const = 0;
};

[[nodiscard]] std::unique_ptr<MbsForm> buildMbsForm(const CompiledModel& model, MbsLaw law);

}  // namespace vehicle
