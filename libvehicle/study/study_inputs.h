#pragma once

#include <string>
#include <vector>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/study.h"
#include "libvehicle/definition/vehicle.h"
#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/model/bound_study.h"

namespace vehicle {

/// A study with everything it names, read and bound: what its designs are made from.
struct StudyInputs {
  Study study;
  Vehicle vehicle;                  // as its file says
  std::vector<Scenario> scenarios;  // in the study's order
  BoundStudy bound;                 // bindStudy() of the three
};

/// Speed at which a case runs [m/s]: its own, or the scenario's where the designs set or vary "speed" themselves.
[[nodiscard]] double speedOf(const BoundStudy& bound, const StudyCase& study_case, const Scenario& scenario);

/// Whether all scenarios and speeds are the same for every design.
[[nodiscard]] bool scenariosAreFixed(const BoundStudy& bound);

/// What is wrong with a design, in one line: the first problem, without the place of the file that the base came from.
[[nodiscard]] std::string firstProblem(const ProblemList& problems);

}  // namespace vehicle
