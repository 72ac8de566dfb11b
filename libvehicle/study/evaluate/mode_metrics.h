#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libvehicle/diagnostics/warning.h"
#include "libvehicle/linear/mode_following.h"
#include "libvehicle/study/evaluate/path.h"

namespace vehicle {

/// Metrics of natural modes. A name means the mode of the study's own vehicle (the design "base") that is called so,
/// and of any design what this mode has become on the straight line from the matrix of the base to that of the design.
///
/// Modes are those of the form that simulate() would take for the base, under the gravity of the first
/// scenario.
class ModeMetrics {
 public:
  /// @param inputs  outlives the object
  explicit ModeMetrics(const StudyInputs& inputs);

  [[nodiscard]] bool empty() const { return metrics_.empty(); }
  /// Fills the metrics of a design; those without a value are left empty with the reason.
  /// @throws InvalidInput, std::runtime_error  if the design has no matrix
  void evaluate(std::size_t row, DesignRows& rows);

  /// Metrics that name a mode which the study's own vehicle does not have, with the nearest name: they have no value in
  /// any design.
  [[nodiscard]] Warnings unknownModes();

 private:
  struct Model {
    Eigen::MatrixXd A;
    std::vector<Channel> states;
  };
  /// The base in one form.
  struct Base : Model {
    std::string form;
    ModeFollower follower;
  };
  [[nodiscard]] Model modelOf(std::span<const double> values, const std::string& form);
  const Base& baseIn(const std::string& form);
  void write(std::size_t row, const Base& base, const Model& design, DesignRows& rows);

  const StudyInputs& inputs_;
  std::vector<MetricPlace> metrics_;  // of modes
  std::vector<double> base_values_;
  Vehicle vehicle_;
  std::vector<Scenario> scenarios_;
  std::string form_;
  std::vector<std::unique_ptr<Base>> bases_;  // of the forms that were needed
};

/// ModeMetrics::unknownModes() of a study.
/// Cost: an eigenvalue problem where a mode is asked for.
[[nodiscard]] Warnings unknownModes(const StudyInputs& inputs);

}  // namespace vehicle
