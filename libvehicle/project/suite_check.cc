#include "libvehicle/project/suite_check.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/project/together.h"
#include "libvehicle/xml/message_text.h"

namespace vehicle {

namespace {

void checkChoices(const std::vector<NamedChoice>& choices, const std::string& kind,
                  const std::vector<std::string>& known, ProblemList& problems) {
  for (const NamedChoice& each : choices) {
    if (std::find(known.begin(), known.end(), each.name) != known.end() || !each.origin.knows("name")) continue;
    const std::optional<std::string> nearest = nearestName(each.name, known);
    problems.add(each.origin, fmt::format("<suite><{}>", kind), fmt::format("{} \"{}\" is unknown", kind, each.name),
                 nearest ? fmt::format("did you mean \"{}\"?", *nearest) : "choose one of " + joined(known, ", "));
  }
}

double speedOf(const ValidationCase& each, const SuiteWork& work) {
  return each.speed.value_or(work.scenarios[each.scenario].run.speed);
}

/// The cases of one vehicle on one scenario differ in speed alone. What is refused at a speed between the lowest and
/// the highest is refused at one of these.
std::vector<ValidationCase> outermostCases(const SuiteWork& work) {
  std::map<std::pair<std::size_t, std::size_t>, std::pair<ValidationCase, ValidationCase>> ends;
  for (const ValidationCase& each : work.cases) {
    auto& [low, high] = ends.try_emplace({each.vehicle, each.scenario}, each, each).first->second;
    if (speedOf(each, work) < speedOf(low, work)) low = each;
    if (speedOf(each, work) > speedOf(high, work)) high = each;
  }
  std::vector<ValidationCase> cases;
  for (const auto& [pair, both] : ends) {
    cases.push_back(both.first);
    if (speedOf(both.first, work) < speedOf(both.second, work)) cases.push_back(both.second);
  }
  return cases;
}

/// Why nothing of a case is judged; empty if something is.
std::string whyNothing(const SuiteWork& work, const ValidationCase& each) {
  const ValidationPlan plan = validationPlanOf(modelOf(work, each), work.choice);
  if (judgesAnything(plan)) return {};
  std::string why;
  for (const Unsupported& unsupported : plan.unsupported) {
    why += why.empty() ? "" : "; ";
    if (unsupported.method.empty()) why += unsupported.form + ": ";
    why += unsupported.reason;
  }
  return why.empty() ? "the reference alone is run" : why;
}

}  // namespace

ProblemList checkNames(const Suite& suite) {
  ProblemList problems;
  checkChoices(suite.forms, "form", formNames(), problems);
  checkChoices(suite.methods, "method", methodNames(), problems);
  return problems;
}

ProblemList checkCases(const SuiteWork& work) {
  ProblemList problems;
  std::set<std::string> known;
  const auto add = [&](const Problem& problem) {
    if (known.insert(problem.text()).second) problems.add(problem);
  };
  for (const ValidationCase& each : outermostCases(work)) {
    const Vehicle& vehicle = work.vehicles[each.vehicle];
    const Scenario& scenario = work.scenarios[each.scenario];
    const ProblemList together = checkTogether(vehicle, scenario, speedOf(each, work));
    for (const Problem& problem : together) add(problem);
    if (!together.empty()) continue;
    const CompiledModel model = modelOf(work, each);
    const ValidationPlan plan = validationPlanOf(model, work.choice);
    const std::string refusal = caseRefusal(plan, model, scenario, speedOf(each, work));
    if (!refusal.empty()) add({scenario.run.origin, "<scenario><run>", vehicle.name + ": " + refusal, ""});
  }
  return problems;
}

Warnings unjudgedOf(const SuiteWork& work) {
  Warnings warnings;
  std::set<std::size_t> vehicles;  // that are warned of
  for (const ValidationCase& each : outermostCases(work)) {
    if (vehicles.contains(each.vehicle)) continue;
    const std::string why = whyNothing(work, each);
    if (why.empty()) continue;
    vehicles.insert(each.vehicle);
    Warning& warning = warnings.emplace_back();
    warning.code = WarningCode::kNothingJudged;
    warning.place = work.suite.vehicles[each.vehicle].origin;
    warning.subject = work.vehicles[each.vehicle].name;
    warning.message = "no two runs of it can be compared: " + why;
    warning.remedy = "name a form and methods that can run it";
  }
  if (warnings.size() < work.vehicles.size()) return warnings;
  Warning whole = warnings.front();
  whole.place = work.suite.origin;
  whole.subject = work.suite.name;
  whole.message = "nothing is judged: no two runs of a vehicle can be compared; " + work.vehicles.front().name + ": " +
                  whyNothing(work, work.cases.front());
  return {whole};
}

}  // namespace vehicle
