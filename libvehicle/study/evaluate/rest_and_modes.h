#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "libvehicle/study/evaluate/path.h"

namespace vehicle {

/// Metrics that know neither speed nor rail: natural modes, and what stands at rest, both under the gravity of the
/// first scenario. Modes are those of the form that simulate() would take; a nonlinear vehicle's are linearised about
/// rest.
class RestAndModes {
 public:
  explicit RestAndModes(const StudyInputs& inputs);

  /// Fills their metrics; designs that have none are failed in the rows.
  void evaluate(DesignRows& rows);

 private:
  void evaluateRest(std::size_t row, double gravity, DesignRows& rows) const;
  void evaluateModes(std::size_t row, double gravity, DesignRows& rows) const;

  const StudyInputs& inputs_;
  Vehicle vehicle_;
  std::vector<Scenario> scenarios_;
  std::vector<MetricPlace> rest_;
  std::vector<MetricPlace> modes_;
};

/// Modes that the metrics name and the study's own vehicle has not, a sentence each with the nearest name. No error:
/// which modes there are changes with the numbers, a design may have them.
/// Cost: one eigenvalue problem where a mode is asked for.
[[nodiscard]] std::vector<std::string> modesInDoubt(const StudyInputs& inputs);

}  // namespace vehicle
