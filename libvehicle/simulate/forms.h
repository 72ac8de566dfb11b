#pragma once

#include <memory>
#include <string>
#include <vector>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/linear/motion_rates.h"
#include "libvehicle/model/compiled_model.h"
#include "libvehicle/system/system.h"

namespace vehicle {

/// flat, matrix, mbs, mbs-linear, and the paper's printed variants flat-7-printed, flat-literal, flat-literal-mb
[[nodiscard]] const std::vector<std::string>& formNames();

/// Why this form cannot represent the vehicle, one problem an element; empty if it can.
/// @throws std::invalid_argument for a form that does not exist, naming the nearest one
[[nodiscard]] ProblemList formUnsupported(const std::string& form, const Topology& topology);

/// Whether the form's x' = f(x, u) is linear, so that matrices, modes and the exact method exist.
[[nodiscard]] bool isLinearForm(const std::string& form);
/// Whether the form is built of Simbody bodies, so that Simbody's own integrator can run it.
[[nodiscard]] bool isSimbodyForm(const std::string& form);
/// Whether the form is a printed variant: kept for teaching, it is not meant to agree with the others.
[[nodiscard]] bool isPrintedVariant(const std::string& form);

/// The form that is taken where none is named: flat where it fits, else matrix.
[[nodiscard]] std::string defaultForm(const Topology& topology);

/// @throws InvalidInput with formUnsupported()
[[nodiscard]] std::unique_ptr<System> buildForm(const std::string& form, const CompiledModel& model);

/// How fast a form moves; of a nonlinear one its linearisation about rest, which is the matrix form.
[[nodiscard]] MotionRates motionRatesOf(const std::string& form, const System& system, const CompiledModel& model);

}  // namespace vehicle
