#include "libvehicle/project/validation_work.h"

#include <optional>
#include <stdexcept>
#include <utility>

#include "libvehicle/project/model.h"
#include "libvehicle/validation/plan.h"
#include "libvehicle/xml/reader.h"

namespace vehicle {

ValidationWork readValidationWork(const ValidationFiles& named, const ValidationChoice& choice, FileSource& files) {
  const std::string& scenario = named.scenario;
  const bool is_suite = kindOf(named.vehicle_or_suite, files).orThrow() == FileKind::kSuite;
  if (is_suite && !scenario.empty()) throw std::invalid_argument("a suite names its scenarios itself; omit SCENARIO");
  if (!is_suite && scenario.empty()) throw std::invalid_argument("SCENARIO is missing, or a suite instead of VEHICLE");
  Settings settings(named.settings);
  if (is_suite) {
    SuiteWork work = readSuiteWork(named.vehicle_or_suite, choice, files, settings).orThrow();
    settings.requireRight();
    return {std::move(work), true};
  }
  Model model = readModel(named.vehicle_or_suite, scenario, files, settings);
  std::vector<ValidationCase> cases;
  for (const double speed : choice.speeds) cases.push_back({0, 0, speed});
  if (cases.empty()) cases.push_back({0, 0, std::nullopt});
  return {{{}, {std::move(model.vehicle.vehicle)}, {std::move(model.scenario)}, std::move(cases), choice}, false};
}

PlannedRuns plannedRuns(const SuiteWork& work) {
  ValidationChoice choice = work.choice;
  choice.shared = usualSharedColumns();
  PlannedRuns planned;
  for (const ValidationCase& each : work.cases) {
    const ValidationPlan plan = validationPlanOf(modelOf(work, each), choice);
    for (const RunKey& run : plan.runs) {
      planned.methods.insert(run.method);
      planned.shares = planned.shares || !run.scheme.empty();
    }
  }
  return planned;
}

std::vector<ValidationReport> validateCases(const SuiteWork& work, const ValidationProgress& progress) {
  const double count = static_cast<double>(work.cases.size());
  std::vector<ValidationReport> reports;
  for (const ValidationCase& each : work.cases) {
    ValidationChoice choice = work.choice;
    choice.run.speed = each.speed;
    const double before = static_cast<double>(reports.size());
    reports.push_back(validate(
        modelOf(work, each), work.scenarios[each.scenario], choice,
        [&](double share, const std::string& what) { return !progress || progress((before + share) / count, what); }));
    if (reports.back().stopped) break;
  }
  return reports;
}

}  // namespace vehicle
