#include "libvehicle/study/evaluate/flat_designs.h"

#include <cmath>
#include <utility>

namespace vehicle {

FlatDesigns::FlatDesigns(const StudyInputs& inputs)
    : inputs_(inputs),
      vehicle_(inputs.vehicle),
      scenarios_(inputs.scenarios),
      topology_(topologyOf(inputs.vehicle)),
      layout_(readLayout(topology_).layout) {
  for (const StudyParameter& each : inputs.bound.parameters) {
    if (!each.in_vehicle) {
      targets_.emplace_back();
      continue;
    }
    targets_.push_back(targetOf(each));
    direct_ = direct_ && targets_.back();
  }
}

std::optional<std::string> FlatDesigns::set(std::span<const double> values) {
  if (!direct_ || by_reference_) return setByReferencePath(values);
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    if (targets_[i] && !isAllowed(*targets_[i], values[i])) return setByReferencePath(values);
  }
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    if (targets_[i]) write(*targets_[i], values[i]);
  }
  return std::nullopt;
}

std::optional<FlatDesigns::Target> FlatDesigns::targetOf(const StudyParameter& parameter) const {
  const Vehicle& base = inputs_.vehicle;
  const VehicleParameter& own = *parameter.in_vehicle;
  if (!own.valueIn(base)) return std::nullopt;  // whether it is given at all matters elsewhere
  const auto at = [&](Number number) { return Target{number, own.index, {}}; };
  if (own.is<&Body::mass>()) return at(Number::kMass);
  if (own.is<&Body::pitch_inertia>()) return at(Number::kInertia);
  if (own.is<&Wheelset::mass>()) return at(Number::kWheelsetMass);
  if (own.is<&Wheelset::load>()) return at(Number::kWheelsetLoad);
  if (own.is<&Suspension::preload>()) return at(Number::kPreload);
  const bool is_stiffness = own.is<&Element::stiffness_z>();
  if (!is_stiffness && !own.is<&Element::damping_z>()) return std::nullopt;  // places, heights, the contact
  Target target = at(is_stiffness ? Number::kStiffness : Number::kDamping);
  for (std::size_t s = 0; s < base.suspensions.size(); ++s) {
    if (base.suspensions[s].element == base.elements[own.index].name) target.spring.push_back(s);
  }
  return target;
}

// At least as strict as check(vehicle): what is not allowed here takes the reference path and is judged there.
bool FlatDesigns::isAllowed(const Target& target, double value) const {
  if (!std::isfinite(value)) return false;
  switch (target.number) {
    case Number::kStiffness:
    case Number::kDamping:
      return value >= 0.0;
    case Number::kPreload:
      return true;
    default:
      return value > 0.0;
  }
}

void FlatDesigns::write(const Target& target, double value) {
  const auto sides = [this](std::size_t suspension) { return inputs_.vehicle.suspensions[suspension].sides; };
  switch (target.number) {
    case Number::kStiffness:
      for (const std::size_t each : target.spring) topology_.suspensions[each].stiffness = sides(each) * value;
      break;
    case Number::kDamping:
      for (const std::size_t each : target.spring) topology_.suspensions[each].damping = sides(each) * value;
      break;
    case Number::kMass:
      topology_.bodies[target.part].mass = value;
      break;
    case Number::kInertia:
      topology_.bodies[target.part].pitch_inertia = value;
      break;
    case Number::kWheelsetMass:
      topology_.wheelsets[target.part].mass = value;
      break;
    case Number::kWheelsetLoad:
      topology_.wheelsets[target.part].load = value;
      break;
    case Number::kPreload:
      topology_.suspensions[target.part].preload = value;
      break;
  }
}

std::optional<std::string> FlatDesigns::setByReferencePath(std::span<const double> values) {
  apply(inputs_.bound, values, vehicle_, scenarios_);
  if (const ProblemList problems = check(vehicle_); !problems.empty()) return firstProblem(problems);
  topology_ = topologyOf(vehicle_);
  FlatReading reading = readLayout(topology_);
  if (!reading.problems.empty()) return firstProblem(reading.problems);
  // Columns are looked up once, by the layout of the base: another front bogie would answer for the first one.
  if (!(reading.layout == layout_)) {
    return "its bogies or wheelsets stand in another order than the base's; give that order a vehicle file and a study "
           "of its own";
  }
  return std::nullopt;
}

}  // namespace vehicle
