#pragma once

#include <complex>
#include <optional>
#include <span>
#include <string>

#include "libvehicle/simulate/simulate.h"

namespace vehicle {

/// A run of dopri5 that was kept to short steps by a mode that has died away.
struct StiffRun {
  double step = 0.0;                     // [s] mean of the run
  double needed = 0.0;                   // [s] what the rest of the motion asks for; infinite if there is none
  std::complex<double> eigenvalue = {};  // [1/s] of that mode
};

/// What a run had to follow, and how closely.
struct FollowedMotion {
  double duration = 0.0;       // [s]
  double tolerance = 0.0;      // [-] of the error of a step, relative to the motion
  double fastest_input = 0.0;  // [rad/s] of the rail under the wheels
};

/// Whether a run is stiff. The error control lets a step err by the tolerance; a step errs by modeError() of each mode.
/// Where that is more than ten tolerances, less than a tenth of the motion is of that mode: it has died away, and only
/// its stability and its last traces keep the steps short. The run is stiff if the fastest mode is such a one and the
/// rest, slower modes and input, would do with steps four times as long. Source of the idea: Hairer, Wanner, Solving
/// Ordinary Differential Equations II, 2nd ed., ch. IV.2 (stiffness detection).
/// @param eigenvalues  [1/s] of the linear equations
[[nodiscard]] std::optional<StiffRun> stiffRun(const Statistics& statistics, const FollowedMotion& motion,
                                               std::span<const std::complex<double>> eigenvalues);

/// What to say of a run by dopri5 that was stiff, with the remedy; empty where it was not, where another method ran, or
/// where the vehicle has more states than its eigenvalues are worth (400).
/// @param choice  that the result was run with
[[nodiscard]] std::string stiffnessNote(const CompiledModel& model, const Scenario& scenario, const RunChoice& choice,
                                        const RunResult& result);

}  // namespace vehicle
