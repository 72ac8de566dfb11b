#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libvehicle/ensemble/design.h"
#include "libvehicle/flat/flat_layout.h"
#include "libvehicle/model/topology.h"
#include "libvehicle/study/study_inputs.h"

namespace vehicle {

/// Makes ensemble designs from parameter values. Where only stiffnesses, dampings, masses, inertias and loads vary, the
/// values go straight into the topology of the base, without looking names up again; everything else, and every
/// value that check() might refuse, takes the reference path over a copy of the vehicle. Both give the same bits.
///
/// Keeps workspace: one object a thread. The vehicle must fit the flat form.
class FlatDesigns {
 public:
  explicit FlatDesigns(const StudyInputs& inputs);

  /// Sets the vehicle to a design's parameters.
  /// @param values  [SI] (parameters)
  /// @return nothing, or what is wrong with that design
  [[nodiscard]] std::optional<std::string> set(std::span<const double> values);

  /// The design that was set, under that gravity.
  /// @throws InvalidInput if its springs cannot carry the weight
  [[nodiscard]] EnsembleDesign design(double gravity) const { return ensembleDesign(topology_, layout_, gravity); }

  [[nodiscard]] const Topology& topology() const { return topology_; }
  [[nodiscard]] const FlatLayout& layout() const { return layout_; }

  /// Whether wheel positions, and with them delays, are those of the base in every design.
  [[nodiscard]] bool geometryIsFixed() const { return direct_; }

  /// The vehicle that was set; only after the reference path.
  [[nodiscard]] const Vehicle& vehicle() const { return vehicle_; }
  /// Takes the reference path always: what the direct one is compared with.
  void useReferencePath() { by_reference_ = true; }

 private:
  enum class Number {
    kStiffness,
    kDamping,
    kMass,
    kInertia,
    kWheelsetMass,
    kWheelsetLoad,
    kPreload
  };
  /// Where a parameter's value goes in the topology.
  struct Target {
    Number number = Number::kMass;
    std::size_t part = 0;             // body, wheelset or suspension
    std::vector<std::size_t> spring;  // suspensions of an element
  };

  [[nodiscard]] std::optional<Target> targetOf(const StudyParameter& parameter) const;
  [[nodiscard]] bool isAllowed(const Target& target, double value) const;
  void write(const Target& target, double value);
  [[nodiscard]] std::optional<std::string> setByReferencePath(std::span<const double> values);

  const StudyInputs& inputs_;
  Vehicle vehicle_;
  std::vector<Scenario> scenarios_;  // written by the reference path, read by nobody
  Topology topology_;
  FlatLayout layout_;
  std::vector<std::optional<Target>> targets_;  // (parameters); nothing: a scenario's
  bool direct_ = true;
  bool by_reference_ = false;
};

}  // namespace vehicle
