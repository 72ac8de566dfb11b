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
  ProblemList (*misfits)(const Vehicle&);
  std::unique_ptr<System> (*build)(const Vehicle&, double gravity);
};

template <FlatVariant variant>
FormEntry printedEntry(const char* name) {
  return {name, Kind::kLinear, Family::kPrinted, [](const Vehicle& vehicle) { return flatMisfits(vehicle, variant); },
          [](const Vehicle& vehicle, double gravity) -> std::unique_ptr<System> {
            return buildFlatForm(vehicle, gravity, variant);
          }};
}

template <MbsLaw law>
FormEntry mbsEntry(const char* name, Kind kind) {
  return {name, kind, Family::kSimbody, [](const Vehicle& vehicle) { return check(vehicle); },
          [](const Vehicle& vehicle, double gravity) -> std::unique_ptr<System> {
            return buildMbsForm(vehicle, gravity, law);
          }};
}

const std::vector<FormEntry>& entries() {
  static const std::vector<FormEntry> table = {
      {"flat", Kind::kLinear, Family::kEquations, flatSystemMisfits, buildFlatSystem},
      {"matrix", Kind::kLinear, Family::kEquations, [](const Vehicle& vehicle) { return check(vehicle); },
       [](const Vehicle& vehicle, double gravity) -> std::unique_ptr<System> {
         return buildMatrixForm(vehicle, gravity);
       }},
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

ProblemList formMisfits(const std::string& form, const Vehicle& vehicle) { return entryOf(form).misfits(vehicle); }
bool isLinearForm(const std::string& form) { return entryOf(form).kind == Kind::kLinear; }
bool isSimbodyForm(const std::string& form) { return entryOf(form).family == Family::kSimbody; }
bool isPrintedVariant(const std::string& form) { return entryOf(form).family == Family::kPrinted; }

std::string defaultForm(const Vehicle& vehicle) { return formMisfits("flat", vehicle).empty() ? "flat" : "matrix"; }

std::unique_ptr<System> buildForm(const std::string& form, const Vehicle& vehicle, double gravity) {
  return entryOf(form).build(vehicle, gravity);  // each builder throws its own misfits
}

}  // namespace vehicle
