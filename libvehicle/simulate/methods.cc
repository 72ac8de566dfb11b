#include "libvehicle/simulate/methods.h"

#include <stdexcept>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/flat/flat_split.h"
#include "libvehicle/flat/flat_train.h"
#include "libvehicle/mbs/mbs_form.h"
#include "libvehicle/partition/schemes/blocked_rk4.h"
#include "libvehicle/simulate/flat_by_type.h"
#include "libvehicle/simulate/flat_split_run.h"
#include "libvehicle/simulate/forms.h"

namespace vehicle {

const std::vector<std::string>& methodNames() {
  static const std::vector<std::string> names = {"rk4", "dopri5", "exact", "simbody_rkm", "rk4_split"};
  return names;
}

bool isSplitMethod(const std::string& method) { return method == "rk4_split"; }

bool isRk4(const std::string& method) { return method == "rk4" || method == "rk4_split"; }
bool isExact(const std::string& method) { return method == "exact"; }

std::string methodUnsupported(const std::string& method, const std::string& form) {
  const bool linear = isLinearForm(form);
  const bool simbody = isSimbodyForm(form);
  if (method == "rk4" || method == "dopri5") return {};
  if (method == "exact")
    return linear
               ? ""
               : fmt::format(
                     "the method exact needs a linear form, and {} is nonlinear; take dopri5, or the form mbs-linear",
                     form);
  if (method == "simbody_rkm") {
    return simbody ? ""
                   : fmt::format(
                         "the method simbody_rkm runs the forms mbs and mbs-linear, not {}; take another method", form);
  }
  if (isSplitMethod(method)) {
    return form == "flat" ? ""
                          : fmt::format("the method {} runs the form flat, not {}; take {}", method, form,
                                        method.substr(0, method.find('_')));
  }
  throw std::invalid_argument(unknownName("method", method, methodNames()));
}

std::string methodUnsupported(const std::string& method, const std::string& form, const CompiledModel& model) {
  if (std::string unsupported = methodUnsupported(method, form); !unsupported.empty()) return unsupported;
  if (!isSplitMethod(method) || !formUnsupported(form, model.topology).empty()) return {};
  return splitMethodUnsupported(method, *buildFlatSystem(model));
}

std::string splitMethodUnsupported(const std::string& method, const System& form) {
  const auto* flat = dynamic_cast<const FlatForm*>(&form);
  const std::string whole = method.substr(0, method.find('_'));
  if (dynamic_cast<const FlatTrain*>(&form) != nullptr) {
    return fmt::format("{}: couplings join the bounce and pitch of a train's vehicles; take {}", method, whole);
  }
  if (flat == nullptr) return fmt::format("{}: the form is not the flat one", method);
  const std::string unsupported = splitUnsupported(*flat);
  return unsupported.empty() ? unsupported : fmt::format("{}: {}; take {}", method, unsupported, whole);
}

SettingsRead settingsReadBy(const std::string& method) {
  if (method == "rk4" || method == "rk4_split") return {.step = true};
  if (method == "dopri5") return {.tolerances = true};
  if (method == "simbody_rkm") return {.accuracy = true};
  if (method == "exact") return {};
  throw std::invalid_argument(unknownName("method", method, methodNames()));
}

std::string defaultMethod(const std::string& form, int states) {
  return isLinearForm(form) && states <= kMostExactStates ? "exact" : "dopri5";
}

std::string defaultMethod(const std::string& form, const Topology& topology) {
  return defaultMethod(form, StateLayout{.coordinates = topology.coordinates}.size());
}

Statistics runMethod(const std::string& method, const System& system, const Input& input, const Schedule& schedule,
                     const MethodSettings& settings, std::span<const double> x0, const Observer& observe) {
  if (method == "exact") return runExact(system, input, schedule, x0, observe);
  const RunProblem problem{system, input, schedule, x0};
  if (method == "dopri5") return runFlatDopri5(problem, settings.accuracy, observe);
  if (method == "rk4") {
    // Three times as fast on a train, whose state and stages would go through the cache four times a step.
    if (dynamic_cast<const FlatTrain*>(&system) != nullptr) {
      return runBlockedRk4(problem, settings.step, observe);
    }
    return runFlatRk4(problem, settings.step, observe);
  }
  if (isSplitMethod(method)) {
    if (const std::string unsupported = splitMethodUnsupported(method, system); !unsupported.empty()) {
      throw std::invalid_argument(unsupported);
    }
    return runFlatRk4Split(problem, settings.step, observe).statistics;
  }
  const auto* mbs = dynamic_cast<const MbsForm*>(&system);
  if (mbs == nullptr) throw std::invalid_argument("simbody_rkm: the form is not made of Simbody bodies");
  return mbs->runSimbody(input, schedule, settings.simbody, x0, observe);
}

}  // namespace vehicle
