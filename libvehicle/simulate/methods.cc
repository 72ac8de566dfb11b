#include "libvehicle/simulate/methods.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/integrate/run.h"
#include "libvehicle/mbs/mbs_form.h"
#include "libvehicle/simulate/flat_by_type.h"
#include "libvehicle/simulate/flat_split_run.h"
#include "libvehicle/simulate/forms.h"

namespace vehicle {

namespace {

Method rk4() {
  return {.name = "rk4",
          .summary = "fixed step",
          .reads = {.step = true},
          .error = {.law = ErrorLaw::kStepHalving, .order = 4},
          .schemes = {Scheme::kSerial, Scheme::kStages, Scheme::kHalo, Scheme::kPipeline},
          .make = [](const RunProblem& problem, const MethodSettings& settings) {
            return makeFlatRk4(problem, settings.step);
          }};
}

// The shares of the adaptive methods: eight vehicles, damped and undamped, at two speeds on two tracks use at most a
// third of them (dopri5 0.015, simbody_rkm 0.050 of the worst sum), because errors change sign and the tolerance bounds
// the lower order's error.
Method dopri5() {
  return {.name = "dopri5",
          .summary = "adaptive step",
          .reads = {.tolerances = true},
          .error = {.law = ErrorLaw::kTolerances, .share = 0.05},
          .alone_because = "it chooses each step from the whole state",
          .make = [](const RunProblem& problem, const MethodSettings& settings) {
            return makeFlatDopri5(problem, settings.accuracy);
          }};
}

Method exact() {
  return {.name = "exact",
          .summary = "matrix exponential",
          .error = {.law = ErrorLaw::kNone},
          .alone_because = "every thread would have to find the same matrices",
          .unsupported =
              [](const std::string& form) {
                if (isLinearForm(form)) return std::string();
                return fmt::format(
                    "the method exact needs a linear form, and {} is nonlinear; take dopri5, or the form mbs-linear",
                    form);
              },
          .make = [](const RunProblem& problem, const MethodSettings&) { return makeExact(problem); }};
}

Method simbodyRkm() {
  return {.name = "simbody_rkm",
          .summary = "adaptive, by Simbody",
          .reads = {.accuracy = true},
          .error = {.law = ErrorLaw::kSimbody, .share = 0.15},
          .unsupported =
              [](const std::string& form) {
                if (isSimbodyForm(form)) return std::string();
                return fmt::format(
                    "the method simbody_rkm runs the forms mbs and mbs-linear, not {}; take another method", form);
              },
          .make =
              [](const RunProblem& problem, const MethodSettings& settings) {
                const auto* mbs = dynamic_cast<const MbsForm*>(&problem.system);
                if (mbs == nullptr) throw std::invalid_argument("simbody_rkm: the form is not made of Simbody bodies");
                return mbs->bySimbody(problem, settings.simbody);
              }};
}

Method rk4Split() {
  return {
      .name = "rk4_split",
      .summary = "fixed step, for a flat vehicle whose front and rear are alike",
      .reads = {.step = true},
      .error = {.law = ErrorLaw::kStepHalving, .order = 4},
      .steps_as = "rk4",
      .schemes = {Scheme::kSerial, Scheme::kSplit},
      .most_threads = 2,
      .unsupported =
          [](const std::string& form) {
            if (form == "flat") return std::string();
            return fmt::format("the method rk4_split runs the form flat, not {}; take rk4", form);
          },
      .unsupportedVehicle = [](const CompiledModel& model) { return splitUnsupportedBy(*buildForm("flat", model)); },
      .make = [](const RunProblem& problem,
                 const MethodSettings& settings) { return makeFlatRk4Split(problem, settings.step); }};
}

std::vector<Method>& table() {
  static std::vector<Method> methods = {rk4(), dopri5(), exact(), simbodyRkm(), rk4Split()};
  return methods;
}

}  // namespace

const Method& methodNamed(const std::string& name) {
  const auto found = std::ranges::find(table(), name, &Method::name);
  if (found == table().end()) throw std::invalid_argument(unknownName("method", name, methodNames()));
  return *found;
}

std::vector<std::string> methodNames() {
  std::vector<std::string> names;
  for (const Method& each : table()) names.push_back(each.name);
  return names;
}

std::string methodSummaries() {
  std::string summaries;
  for (const Method& each : table()) {
    summaries += fmt::format("{}{} ({})", summaries.empty() ? "" : " | ", each.name, each.summary);
  }
  return summaries;
}

void addMethod(Method method) {
  if (method.make == nullptr) {
    throw std::invalid_argument(fmt::format("method {}: has no make, which builds its integrator", method.name));
  }
  if (std::ranges::find(table(), method.name, &Method::name) != table().end()) {
    throw std::invalid_argument(fmt::format("method {}: there is one of that name; choose another", method.name));
  }
  table().push_back(std::move(method));
}

std::string methodUnsupported(const std::string& method, const std::string& form) {
  const Method& entry = methodNamed(method);
  return entry.unsupported == nullptr ? "" : entry.unsupported(form);
}

std::string methodUnsupported(const std::string& method, const std::string& form, const CompiledModel& model) {
  if (std::string unsupported = methodUnsupported(method, form); !unsupported.empty()) return unsupported;
  const Method& entry = methodNamed(method);
  if (entry.unsupportedVehicle == nullptr || !formUnsupported(form, model.topology).empty()) return {};
  return entry.unsupportedVehicle(model);
}

std::string defaultMethod(const std::string& form, int states) {
  return isLinearForm(form) && states <= kMostExactStates ? "exact" : "dopri5";
}

std::string defaultMethod(const std::string& form, const Topology& topology) {
  return defaultMethod(form, StateLayout{.coordinates = topology.coordinates}.size());
}

}  // namespace vehicle
