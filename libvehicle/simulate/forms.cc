#include "libvehicle/simulate/forms.h"

#include <stdexcept>

#include "libvehicle/flat/flat_form.h"
#include "libvehicle/flat/flat_train.h"
#include "libvehicle/matrix/matrix_form.h"
#include "libvehicle/mbs/mbs_form.h"

namespace vehicle {

namespace {

enum class Kind { kLinear, kNonlinear };
enum class Family { kEquations, kSimbody, kPrinted };

// One line a form: a new form is added here and nowhere else in this room.
struct FormEntry {
  std::string name;
  Kind kind;
  Family family;
  ProblemList (*unsupported)(const Topology&);
  std::unique_ptr<System> (*build)(const CompiledModel&);
};

ProblemList nothing(const Topology& /*topology*/) { return {}; }  // of a form that takes any vehicle

template <FlatVariant variant>
FormEntry printedEntry(const char* name) {
  return {name, Kind::kLinear, Family::kPrinted,
          [](const Topology& topology) { return flatUnsupported(topology, variant); },
          [](const CompiledModel& model) -> std::unique_ptr<System> { return buildFlatForm(model, variant); }};
}

template <MbsLaw law>
FormEntry mbsEntry(const char* name, Kind kind) {
  return {name, kind, Family::kSimbody, nothing,
          [](const CompiledModel& model) -> std::unique_ptr<System> { return buildMbsForm(model, law); }};
}

const std::vector<FormEntry>& entries() {
  static const std::vector<FormEntry> table = {
      {"flat", Kind::kLinear, Family::kEquations, flatSystemUnsupported, buildFlatSystem},
      {"matrix", Kind::kLinear, Family::kEquations, nothing,
       [](const CompiledModel& model) -> std::unique_ptr<System> { return buildMatrixForm(model); }},
      mbsEntry<MbsLaw::kLinear>("mbs-linear", Kind::kLinear),
      mbsEntry<MbsLaw::kTrue>("mbs", Kind::kNonlinear),
      printedEntry<FlatVariant::kPrinted7>("flat-7-printed"),
      printedEntry<FlatVariant::kLiteral>("flat-literal"),
      printedEntry<FlatVariant::kLiteralMb>("flat-literal-mb"),
  };
  return table;
}

const FormEntry& entryOf(const std::string& form) {
  for (const FormEntry& entry : entries()) {
    if (entry.name == form) return entry;
  }
  throw std::invalid_argument(unknownName("form", form, formNames()));
}

}  // namespace

const std::vector<std::string>& formNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const FormEntry& entry : entries()) list.push_back(entry.name);
    return list;
  }();
  return names;
}

ProblemList formUnsupported(const std::string& form, const Topology& topology) {
  return entryOf(form).unsupported(topology);
}
bool isLinearForm(const std::string& form) { return entryOf(form).kind == Kind::kLinear; }
bool isSimbodyForm(const std::string& form) { return entryOf(form).family == Family::kSimbody; }
bool isPrintedVariant(const std::string& form) { return entryOf(form).family == Family::kPrinted; }

std::string defaultForm(const Topology& topology) {
  return formUnsupported("flat", topology).empty() ? "flat" : "matrix";
}

std::unique_ptr<System> buildForm(const std::string& form, const CompiledModel& model) {
  return entryOf(form).build(model);  // each builder throws what speaks against the form
}

MotionRates motionRatesOf(const std::string& form, const System& system, const CompiledModel& model) {
  return isLinearForm(form) ? MotionRates(system) : MotionRates(*buildMatrixForm(model));
}

}  // namespace vehicle
