#pragma once

#include <cstddef>
#include <exception>
#include <string>
#include <vector>

#include "libvehicle/ensemble/design.h"
#include "libvehicle/study/evaluate/flat_designs.h"
#include "libvehicle/study/evaluate/path.h"
#include "libvehicle/system/input.h"

namespace vehicle {

/// A block of designs made ready for an ensemble: what the lanes need, case by case.
///
/// Where no design changes a scenario or the place of a wheel, every case has one rail, made once; else each design has
/// rails of its own. Designs are shared by the cases of equal gravity that start at rest.
class FlatBlock {
 public:
  /// @param evaluation  of a steady state the rail has always been there, and the start does not matter
  FlatBlock(const StudyInputs& inputs, Evaluation evaluation);

  /// Makes the designs of the rows; those that cannot be are failed there and left out.
  void prepare(DesignRows& rows);

  /// Row of each design that is left.
  [[nodiscard]] const std::vector<std::size_t>& alive() const { return alive_; }
  [[nodiscard]] bool railsAreShared() const { return shared_; }
  [[nodiscard]] std::size_t groupOf(std::size_t study_case) const { return group_[study_case]; }
  [[nodiscard]] std::size_t groups() const { return designs_.size(); }
  /// Designs that are left, as a group of cases needs them, shape (alive).
  [[nodiscard]] const std::vector<EnsembleDesign>& designs(std::size_t group) const { return designs_[group]; }
  /// Rail of a case where it is shared; channels are the wheels 1 to 4.
  [[nodiscard]] const Input& rail(std::size_t study_case) const { return shared_rails_[study_case]; }
  /// Rails of a case, shape (alive), where each design has its own.
  [[nodiscard]] const std::vector<Input>& rails(std::size_t study_case) const { return rails_[study_case]; }
  /// Output step of a case [s] for the design in that place of alive(), with its parameters.
  [[nodiscard]] double outputStep(std::size_t study_case, std::size_t place) const;

  /// A column of the vehicle by its name, which choosePath() has found among those of the ensemble.
  [[nodiscard]] FlatColumn column(const std::string& name) const;

 private:
  void add(std::size_t row, DesignRows& rows);
  [[nodiscard]] Input railOf(const StudyCase& study_case, const Scenario& scenario) const;
  [[nodiscard]] bool startsAtRest(const Scenario& scenario) const;
  [[nodiscard]] std::array<double, 8> startOf(const Scenario& scenario, const Input& rail_in_file_order) const;

  const StudyInputs& inputs_;
  bool steady_;
  FlatDesigns maker_;
  bool shared_;
  std::vector<std::size_t> group_;       // (cases)
  std::vector<std::size_t> group_case_;  // (groups) a case of it
  std::vector<Input> shared_rails_;      // (cases) where shared
  std::vector<std::size_t> alive_;
  std::vector<std::vector<EnsembleDesign>> designs_;  // (groups x alive)
  std::vector<std::vector<Input>> rails_;             // (cases x alive) where not shared
  std::vector<std::vector<double>> output_steps_;     // (scenarios x alive) where not shared
  Vehicle vehicle_;                                   // workspace of the reference path
  std::vector<Scenario> scenarios_;
};

/// What an exception says about a design: the first problem, or its text.
[[nodiscard]] std::string designProblem(const std::exception& error);

}  // namespace vehicle
