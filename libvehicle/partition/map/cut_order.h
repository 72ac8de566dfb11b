#pragma once

#include <optional>
#include <vector>

#include "libvehicle/system/run_problem.h"

namespace vehicle {

/// The equations of a system.
/// @throws std::invalid_argument if it cannot be cut
[[nodiscard]] const EquationSet& equationsOf(const System& system);

/// A run's system, input and start as the equations want them: in cut order. Looks at system and input.
class CutRun {
 public:
  /// @throws std::invalid_argument if the system cannot be cut into equations, or as checkChannels() and checkStart()
  explicit CutRun(const RunProblem& problem);

  [[nodiscard]] const EquationSet& set() const { return *set_; }
  [[nodiscard]] const Input& input() const { return reordered_ ? *reordered_ : *input_; }
  [[nodiscard]] const std::vector<double>& x0() const { return x0_; }

 private:
  const EquationSet* set_;
  const Input* input_;
  std::optional<Input> reordered_;  // where the two orders differ
  std::vector<double> x0_;
};

}  // namespace vehicle
