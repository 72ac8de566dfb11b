#pragma once

#include <cstddef>
#include <vector>

#include "libvehicle/study/evaluate/mode_metrics.h"
#include "libvehicle/study/evaluate/path.h"

namespace vehicle {

/// Metrics that know neither speed nor rail: natural modes (mode_metrics.h), and what stands at rest under the gravity
/// of the first scenario.
class RestAndModes {
 public:
  explicit RestAndModes(const StudyInputs& inputs);

  /// Fills their metrics or leaves them empty; designs that cannot be are failed in the rows.
  void evaluate(DesignRows& rows);

 private:
  void evaluateRest(std::size_t row, DesignRows& rows);

  const StudyInputs& inputs_;
  Vehicle vehicle_;
  std::vector<Scenario> scenarios_;
  std::vector<MetricPlace> rest_;
  ModeMetrics modes_;
};

}  // namespace vehicle
