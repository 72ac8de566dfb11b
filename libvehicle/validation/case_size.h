#pragma once

#include <Eigen/Core>

#include "libvehicle/model/compiled_model.h"
#include "libvehicle/result/time_history.h"
#include "libvehicle/system/input.h"
#include "libvehicle/validation/geometry.h"
#include "libvehicle/validation/sensitivity.h"

namespace vehicle {

/// A vehicle on its track as the ledger sees it. One serves all forms of the same linear equations. (outputs) are the
/// columns of model.outputs, (n) the states of model.states.
struct CaseSize {
  CompiledModel model;
  Sensitivity sensitivity;
  MotionSize motion;               // of the reference run
  Eigen::VectorXd input_rounding;  // (2 w) [m, m/s] what the input sweeps of a fixed-step run may round
  double duration = 0.0;           // [s]
  double output_step = 0.0;        // [s]
};

/// @param system     the linear form whose equations the runs have
/// @param reference  a history of these equations, samples close enough to show its peaks
/// @param output_step  [s] of the runs that are judged
[[nodiscard]] CaseSize sizeOfCase(const System& system, const CompiledModel& model, const Input& input,
                                  const TimeHistory& reference, double output_step);

}  // namespace vehicle
