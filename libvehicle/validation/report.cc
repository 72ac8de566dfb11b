#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libvehicle/validation/validation.h"

namespace vehicle {

const std::vector<SharedColumn>& usualSharedColumns() {
  static const std::vector<SharedColumn> usual = {{"rk4", "stages", 4, "paper"},
                                                  {"rk4", "halo", 2, "auto"},
                                                  {"rk4", "pipeline", 2, "auto"},
                                                  {"rk4_split", "split", 2, "auto"}};
  return usual;
}

bool ValidationReport::inside() const {
  const bool finished = std::all_of(runs.begin(), runs.end(),
                                    [](const ValidationRun& run) { return run.ending == RunEnding::kFinished; });
  return finished && count(Verdict::kInside) > 0 && count(Verdict::kOutside) == 0 && count(Verdict::kNotJudged) == 0;
}

bool ValidationReport::failed() const {
  return std::any_of(runs.begin(), runs.end(),
                     [](const ValidationRun& run) { return run.ending == RunEnding::kFailed; });
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
