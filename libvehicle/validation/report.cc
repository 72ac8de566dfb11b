#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libvehicle/validation/validation.h"

namespace vehicle {

const std::vector<SharedColumn>& usualSharedColumns() {
  static const std::vector<SharedColumn> usual = {
      {"rk4", "stages", 4, "paper"}, {"rk4", "halo", 2, "auto"},        {"rk4", "pipeline", 2, "auto"},
      {"exact", "rows", 2, "auto"},  {"rk4_split", "split", 2, "auto"}, {"exact_split", "split", 2, "auto"}};
  return usual;
}

bool ValidationReport::inside() const {
  for (const ValidationRun& run : runs) {
    if (!run.failure.empty()) return false;
  }
  return count(Verdict::kInside) > 0 && count(Verdict::kOutside) == 0;
}

std::size_t ValidationReport::count(Verdict verdict) const {
  return static_cast<std::size_t>(
      std::count_if(pairs.begin(), pairs.end(), [&](const PairAgreement& pair) { return pair.verdict == verdict; }));
}

std::vector<ValidationCase> casesOf(const Suite& suite) {
  std::vector<std::optional<double>> speeds;
  for (const double speed : speedsOf(suite)) speeds.emplace_back(speed);
  if (speeds.empty()) speeds.emplace_back();
  std::vector<ValidationCase> cases;
  for (std::size_t vehicle = 0; vehicle < suite.vehicles.size(); ++vehicle) {
    for (std::size_t scenario = 0; scenario < suite.scenarios.size(); ++scenario) {
      for (const std::optional<double>& speed : speeds) cases.push_back({vehicle, scenario, speed});
    }
  }
  return cases;
}

ValidationChoice choiceOf(const Suite& suite, ValidationChoice choice) {
  if (choice.forms.empty()) {
    for (const NamedChoice& form : suite.forms) choice.forms.push_back(form.name);
  }
  if (choice.methods.empty()) {
    for (const NamedChoice& method : suite.methods) choice.methods.push_back(method.name);
  }
  return choice;
}

}  // namespace vehicle
