#pragma once

#include <span>
#include <string>
#include <vector>

#include "libvehicle/integrate/run.h"
#include "libvehicle/model/compiled_model.h"
#include "libvehicle/system/system.h"

namespace vehicle {

/// rk4, dopri5, exact, simbody_rkm, and rk4_split: rk4 in bounce and pitch coordinates, for a flat vehicle whose front
/// and rear are alike
[[nodiscard]] const std::vector<std::string>& methodNames();
/// Whether the method runs bounce and pitch apart.
[[nodiscard]] bool isSplitMethod(const std::string& method);

/// rk4 and rk4_split: the same steps and the same integration error, in other coordinates.
[[nodiscard]] bool isRk4(const std::string& method);
[[nodiscard]] bool isExact(const std::string& method);

/// Why this method cannot integrate that form ("exact needs a linear form; mbs is nonlinear"); empty if it can.
/// @throws std::invalid_argument for a name that does not exist, naming the nearest one
[[nodiscard]] std::string methodUnsupported(const std::string& method, const std::string& form);
/// The same for one vehicle: rk4_split needs one that bounces and pitches apart. Empty where the form
/// itself does not fit the vehicle: that is formUnsupported()'.
[[nodiscard]] std::string methodUnsupported(const std::string& method, const std::string& form,
                                            const CompiledModel& model);

/// Most states that exact is taken for where no method is named. Its work grows with their cube, and with the breakpoints of
/// the rail under every wheel: a train of more than eight flat vehicles is run by dopri5 sooner.
inline constexpr int kMostExactStates = 64;

/// The method that is taken where none is named: exact where it fits and there are few states, else dopri5.
/// @param states  of the form
[[nodiscard]] std::string defaultMethod(const std::string& form, int states);
/// The same for that vehicle or train.
[[nodiscard]] std::string defaultMethod(const std::string& form, const Topology& topology);

/// The settings of all methods; each reads its own.
struct MethodSettings {
  FixedStep step;           // rk4, rk4_split
  Accuracy accuracy;        // dopri5
  double simbody = 1e-10;   // simbody_rkm: Simbody's weighted norm
};

/// Which of the settings a method reads; the others have no effect on its run.
struct SettingsRead {
  bool step = false;
  bool tolerances = false;  // relative and absolute
  bool accuracy = false;    // of Simbody
};
/// @throws std::invalid_argument for a name that does not exist, naming the nearest one
[[nodiscard]] SettingsRead settingsReadBy(const std::string& method);

/// Why the split methods cannot run this form ("rk4_split: ... the rear one = 9500 kg; take rk4"); empty if they can.
[[nodiscard]] std::string splitMethodUnsupported(const std::string& method, const System& form);

/// Integrates a form over the schedule by the named method, on the caller's own thread.
Statistics runMethod(const std::string& method, const System& system, const Input& input, const Schedule& schedule,
                     const MethodSettings& settings, std::span<const double> x0, const Observer& observe);

}  // namespace vehicle
