#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/definition/attribute.h"
#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/vehicle.h"
#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/units/quantity.h"

namespace vehicle {

/// One number of a vehicle or scenario, addressed by name: what studies vary and --set sets.
///
///     primary.stiffness_z, carbody.mass, front.x          part and attribute, as in the vehicle file
///     speed                                               of the scenario's run
///     scenario.gravity, .duration, .distance, .output_step, .fade_in
///     scenario.NAME.amplitude                             a named member of the track or sine of the rig
/// It is bound to one arrangement of parts: good for every copy of that vehicle or scenario, whatever its numbers.
template <class Owner>
struct ParameterOf {
  std::string address;
  Dimension dimension = Dimension::kNumber;
  const AttributeRow* row = nullptr;  // what the table says of it; lives as long as the program
  std::size_t index = 0;              // of the part among those of its kind
  void* (*part)(Owner& owner, std::size_t index) = nullptr;

  /// [SI]; nothing where the file gives no value (a load, a height).
  [[nodiscard]] std::optional<double> valueIn(const Owner& owner) const {
    return row->numberIn(part(const_cast<Owner&>(owner), index));  // finds the part and changes nothing
  }
  void setIn(Owner& owner, double si) const { row->set(part(owner, index), si); }

  /// Whether it is that member of the part of that index: is<&Element::stiffness_z>().
  template <auto kMember>
  [[nodiscard]] bool is() const {
    return row->member == &kIdOf<kMember>;
  }
};
using VehicleParameter = ParameterOf<Vehicle>;
using ScenarioParameter = ParameterOf<Scenario>;

/// Every number that can be addressed: the rows of the table that may vary, parts in the order of the file within their
/// kind. Quantities kept for forms to come (roll_inertia, ...) are no parameters: no result depends on them.
[[nodiscard]] std::vector<VehicleParameter> parametersOf(const Vehicle& vehicle);
[[nodiscard]] std::vector<ScenarioParameter> parametersOf(const Scenario& scenario);

/// What to say of an address that leads nowhere: the nearest of those that exist, or what its part has.
/// @returns message and remedy, without place
[[nodiscard]] Problem unknownParameter(const std::string& address, const std::vector<std::string>& addresses);

/// @returns null if there is none of that address
template <class Owner>
[[nodiscard]] const ParameterOf<Owner>* findParameter(const std::vector<ParameterOf<Owner>>& parameters,
                                                      std::string_view address) {
  for (const ParameterOf<Owner>& each : parameters) {
    if (each.address == address) return &each;
  }
  return nullptr;
}

}  // namespace vehicle
