#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libvehicle/model/bound_study.h"
#include "libvehicle/study/plan/design_plan.h"
#include "tests/support/studies.h"
#include "tests/support/vehicles.h"

// Studies of the paper's vehicle on a track of two waves, built by hand.
namespace vehicle::test {

inline Study studyOf(std::vector<Vary> varies, PlanKind kind = PlanKind::kGrid, std::optional<int> size = {}) {
  Study made;
  made.name = "study";
  made.vehicle.file = "vehicle.xml";
  made.scenarios = {{"waves.xml", {}}};
  made.varies = std::move(varies);
  made.plan.emplace();
  made.plan->kind = kind;
  made.plan->size = size;
  made.metrics = {{"carbody.az.rms", {}}};
  return made;
}

/// The plan of a study in order; the tests check that it is.
inline DesignPlan planOf(const Study& study) {
  ProblemList problems = check(study);
  if (!problems.empty()) throw InvalidInput(problems);
  return DesignPlan::of(study, bindStudy(study, paperVehicle(), {waves()}).orThrow()).orThrow();
}

inline std::vector<double> valuesOf(const DesignPlan& plan, std::uint64_t design) {
  std::vector<double> values(plan.study().parameters.size());
  plan.valuesOf(design, values);
  return values;
}

}  // namespace vehicle::test
