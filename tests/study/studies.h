#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libvehicle/definition/bound_study.h"
#include "libvehicle/study/plan/design_plan.h"
#include "tests/support/vehicles.h"

// Studies of the paper's vehicle on a track of two waves, built by hand.
namespace vehicle::test {

inline Scenario waves() {
  Scenario made;
  made.name = "waves";
  made.run.speed = 20.0;
  made.run.duration = 10.0;
  made.track.emplace();
  Harmonic wave;
  wave.name = "wave";
  wave.wavelength = 25.0;
  wave.amplitude = 5e-3;
  made.track->harmonics = {wave};
  return made;
}

inline Vary range(std::string parameter, std::string from, std::string to, std::optional<int> count = {}) {
  Vary made;
  made.parameter = std::move(parameter);
  made.from = std::move(from);
  made.to = std::move(to);
  made.count = count;
  return made;
}

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
