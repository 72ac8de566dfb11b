#pragma once

#include <span>
#include <string>
#include <vector>

#include "libvehicle/integrate/run.h"
#include "libvehicle/system/system.h"

namespace vehicle {

/// rk4, dopri5, exact, simbody_rkm
[[nodiscard]] const std::vector<std::string>& methodNames();

/// Why this method cannot integrate that form ("exact needs a linear form; mbs is nonlinear"); empty if it can.
/// @throws std::invalid_argument for a name that does not exist, naming the nearest one
[[nodiscard]] std::string methodMisfit(const std::string& method, const std::string& form);

/// The method that is taken where none is named: exact where it fits, else dopri5.
[[nodiscard]] std::string defaultMethod(const std::string& form);

/// The settings of all methods; each reads its own.
struct MethodSettings {
  FixedStep step;           // rk4
  Accuracy accuracy;        // dopri5
  double simbody = 1e-10;   // simbody_rkm: Simbody's weighted norm
};

/// Integrates a form over the schedule by the named method.
Statistics runMethod(const std::string& method, const System& system, const Input& input, const Schedule& schedule,
                     const MethodSettings& settings, std::span<const double> x0, const Observer& observe);

}  // namespace vehicle
