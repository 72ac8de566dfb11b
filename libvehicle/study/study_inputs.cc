#include "libvehicle/study/study_inputs.h"

#include <algorithm>

namespace vehicle {

double speedOf(const BoundStudy& bound, const StudyCase& study_case, const Scenario& scenario) {
  const bool own = std::any_of(bound.parameters.begin(), bound.parameters.end(),
                               [](const StudyParameter& each) { return each.address == "speed"; });
  return own ? scenario.run.speed : study_case.speed;
}

bool scenariosAreFixed(const BoundStudy& bound) {
  return std::all_of(bound.parameters.begin(), bound.parameters.end(),
                     [](const StudyParameter& each) { return each.in_vehicle.has_value(); });
}

std::string firstProblem(const ProblemList& problems) {
  if (problems.empty()) return "is not possible";
  const Problem& first = problems[0];
  std::string text = first.element.empty() ? first.message : first.element + ": " + first.message;
  if (!first.remedy.empty()) text += "; " + first.remedy;
  return text;
}

}  // namespace vehicle
