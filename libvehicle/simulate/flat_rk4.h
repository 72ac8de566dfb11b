#pragma once

#include <span>

#include "libvehicle/flat/flat_form.h"
#include "libvehicle/integrate/run.h"

namespace vehicle {

/// rk4 on the flat form by type: the compiler sees equations and stepper as one, no virtual call in between.
/// Gives the bits of runRk4() on the same form; the printed variants go that way.
Statistics runFlatRk4(const FlatForm& form, const Input& input, const Schedule& schedule, FixedStep step,
                      std::span<const double> x0, const Observer& observe);

}  // namespace vehicle
