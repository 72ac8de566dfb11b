#pragma once

#include <span>
#include <string>
#include <vector>

#include "libvehicle/matrix/assembly.h"
#include "libvehicle/model/compiled_model.h"
#include "libvehicle/system/equation_set.h"

namespace vehicle {

/// The equations of motion of any topology cut into equations, one a coordinate:
///
///     q_i'' = sum_j (-K_ij/m_i q_j - C_ij/m_i q_j') + sum_j (B0_ij/m_i eta_j + B1_ij/m_i eta_j')
///
/// over the places that are not zero. Cut order counts parts and wheelsets from the front, so that the vehicles of a
/// train are neighbours in memory; both sums run in it from left to right, whoever computes them.
class MatrixEquationSet final : public EquationSet {
 public:
  /// @param matrices  of that model
  MatrixEquationSet(const CompiledModel& model, const SparseSecondOrder& matrices);

  [[nodiscard]] int channels() const override { return static_cast<int>(channel_order_.size()); }
  [[nodiscard]] const std::vector<Equation>& equations() const override { return equations_; }
  [[nodiscard]] const std::vector<int>& stateOrder() const override { return state_order_; }
  [[nodiscard]] const std::vector<int>& channelOrder() const override { return channel_order_; }
  void derivative(const EquationWindow& window) const override;

  /// Acceleration of coordinate q of the topology, with state and input in the order of the System: the same bits.
  [[nodiscard]] double acceleration(int q, const double* x, const double* u) const;

 private:
  /// What one coordinate, or the rail under one wheel, does to another: places in cut order and in the topology's.
  struct Entry {
    int cut = 0;
    int own = 0;
    double stiffness = 0.0;  // over the mass [1/s^2 and mixed]
    double damping = 0.0;    // over the mass [1/s and mixed]
  };
  struct Movement;
  template <class Displacement, class Rail>
  double sum(int equation, Displacement displacement, Rail rail) const;

  std::vector<int> equation_of_;  // (N) of each coordinate of the topology
  std::vector<Entry> entries_;    // row by row: what bodies do, then what the rail does
  std::vector<int> row_begin_;    // (2 N + 1) in entries_: two a row
  std::vector<Equation> equations_;
  std::vector<int> state_order_;
  std::vector<int> channel_order_;
};

}  // namespace vehicle
