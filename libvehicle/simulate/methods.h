#pragma once

#include <memory>
#include <string>
#include <vector>

#include "libvehicle/integrate/integrator.h"
#include "libvehicle/integrate/step_control.h"
#include "libvehicle/integrate/step_walk.h"
#include "libvehicle/model/compiled_model.h"
#include "libvehicle/partition/scheme.h"
#include "libvehicle/system/run_problem.h"

namespace vehicle {

/// The settings of all methods; each reads its own.
struct MethodSettings {
  FixedStep step;          // of fixed steps
  Accuracy accuracy;       // of adaptive ones
  double simbody = 1e-10;  // Simbody's weighted norm
};

/// Which of the settings a method reads; the others have no effect on its run.
struct SettingsRead {
  bool step = false;
  bool tolerances = false;  // relative and absolute
  bool accuracy = false;    // of Simbody
};

/// What the size of a method's own error follows from; validation/ledger.cc makes columns of it.
enum class ErrorLaw {
  kNone,         // it is exact but for rounding
  kStepHalving,  // of a known order in the step: Richardson's estimate
  kTolerances,   // each step errs by its tolerances at most
  kSimbody,      // the same in Simbody's norm
};

/// The error that is expected of a method.
struct ExpectedError {
  ErrorLaw law = ErrorLaw::kNone;
  int order = 0;       // kStepHalving
  double share = 0.0;  // kTolerances, kSimbody: of the worst sum of step errors
};

/// A method: one line of the table in methods.cc, which commands, runs and validation read.
struct Method {
  std::string name;
  std::string summary;  // as --help has it
  SettingsRead reads{};
  ExpectedError error;
  std::string steps_as{};         // the method whose steps and integration error it has; empty: its own
  std::vector<Scheme> schemes{};  // by which threads can share its work, serial first; empty: serial alone
  int most_threads = 0;           // 0: as many as there are equations
  std::string alone_because{};    // why it runs on one thread, where it does; ends a sentence that names it

  /// Why it cannot run that form, with the remedy; empty if it can. nullptr: it runs all.
  std::string (*unsupported)(const std::string& form) = nullptr;
  /// The same for one vehicle whose form it can run, where not every vehicle is fit. nullptr: every one is.
  std::string (*unsupportedVehicle)(const CompiledModel& model) = nullptr;
  /// @throws std::invalid_argument  for settings, input or system that do not fit
  std::unique_ptr<Integrator> (*make)(const RunProblem& problem, const MethodSettings& settings) = nullptr;

  /// The method whose steps it makes: two of one family and one step have the same integration error.
  [[nodiscard]] const std::string& family() const { return steps_as.empty() ? name : steps_as; }
};

/// @throws std::invalid_argument for a name that does not exist, naming the nearest one
[[nodiscard]] const Method& methodNamed(const std::string& name);
[[nodiscard]] std::vector<std::string> methodNames();
/// All of them in one sentence, for --help.
[[nodiscard]] std::string methodSummaries();

/// Adds a method of the program's own; it then is known by name like the others. To be called before the first run.
/// @throws std::invalid_argument if the name is taken or there is no make
void addMethod(Method method);

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

}  // namespace vehicle
