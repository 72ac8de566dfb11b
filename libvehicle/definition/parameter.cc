#include "libvehicle/definition/parameter.h"

#include "libvehicle/definition/scenario_attributes.h"
#include "libvehicle/definition/vehicle_attributes.h"

namespace vehicle {

namespace {

/// What may vary of all parts in a list of the vehicle.
template <auto kParts>
void add(std::vector<VehicleParameter>& to, const Vehicle& vehicle) {
  const auto& parts = vehicle.*kParts;
  for (const AttributeRow& row : attributesOf<typename TypeOf<kParts>::value_type>()) {
    for (std::size_t i = 0; row.varies && i < parts.size(); ++i) {
      to.push_back({parts[i].name + '.' + std::string(row.name), row.dimension, &row, i,
                    [](Vehicle& owner, std::size_t index) -> void* { return &(owner.*kParts)[index]; }});
    }
  }
}

/// The same for the named members of a track.
template <auto kMembers>
void addMembers(std::vector<ScenarioParameter>& to, const Track& track) {
  const auto& members = track.*kMembers;
  for (const AttributeRow& row : attributesOf<typename TypeOf<kMembers>::value_type>()) {
    for (std::size_t i = 0; row.varies && i < members.size(); ++i) {
      if (members[i].name.empty()) continue;
      to.push_back({"scenario." + members[i].name + '.' + std::string(row.name), row.dimension, &row, i,
                    [](Scenario& owner, std::size_t index) -> void* { return &((*owner.track).*kMembers)[index]; }});
    }
  }
}

/// The sine of that number, counted through all inputs of the rig.
void* sineIn(Scenario& scenario, std::size_t index) {
  std::size_t input = 0;
  for (; index >= scenario.rig->inputs[input].sines.size(); ++input) index -= scenario.rig->inputs[input].sines.size();
  return &scenario.rig->inputs[input].sines[index];
}

/// The same for the named sines of a rig.
void addSines(std::vector<ScenarioParameter>& to, const Rig& rig) {
  for (const AttributeRow& row : attributesOf<RigSine>()) {
    std::size_t index = 0;
    for (const RigInput& input : rig.inputs) {
      for (const RigSine& sine : input.sines) {
        const std::size_t own = index++;
        if (!row.varies || sine.name.empty()) continue;
        to.push_back({"scenario." + sine.name + '.' + std::string(row.name), row.dimension, &row, own, &sineIn});
      }
    }
  }
}

/// What may vary of a part that the scenario has once.
template <class Part>
void addOnly(std::vector<ScenarioParameter>& to, void* (*part)(Scenario& owner, std::size_t index)) {
  for (const AttributeRow& row : attributesOf<Part>()) {
    if (!row.varies) continue;
    const std::string name(row.name);
    to.push_back({row.member == &kIdOf<&Run::speed> ? name : "scenario." + name, row.dimension, &row, 0, part});
  }
}

}  // namespace

std::vector<VehicleParameter> parametersOf(const Vehicle& vehicle) {
  std::vector<VehicleParameter> all;
  add<&Vehicle::elements>(all, vehicle);
  add<&Vehicle::groups>(all, vehicle);
  add<&Vehicle::bodies>(all, vehicle);
  add<&Vehicle::wheelsets>(all, vehicle);
  add<&Vehicle::suspensions>(all, vehicle);
  add<&Vehicle::points>(all, vehicle);
  return all;
}

Problem unknownParameter(const std::string& address, const std::vector<std::string>& addresses) {
  Problem problem;
  problem.message = "parameter \"" + address + "\" is unknown";
  if (const std::optional<std::string> nearest = nearestName(address, addresses)) {
    problem.remedy = "did you mean \"" + *nearest + "\"?";
    return problem;
  }
  const std::string part = address.substr(0, address.rfind('.')) + '.';
  std::string list;
  for (const std::string& each : addresses) {
    if (each.starts_with(part)) list += (list.empty() ? "; it has " : ", ") + each;
  }
  problem.remedy = "write PART.ATTRIBUTE" + list;
  if (list.empty()) problem.remedy += ", e.g. " + addresses.front() + ", or speed, or scenario.NAME.ATTRIBUTE";
  return problem;
}

std::vector<ScenarioParameter> parametersOf(const Scenario& scenario) {
  std::vector<ScenarioParameter> all;
  addOnly<Scenario>(all, [](Scenario& owner, std::size_t) -> void* { return &owner; });
  addOnly<Run>(all, [](Scenario& owner, std::size_t) -> void* { return &owner.run; });
  if (scenario.track) {
    addOnly<Track>(all, [](Scenario& owner, std::size_t) -> void* { return &*owner.track; });
    addMembers<&Track::harmonics>(all, *scenario.track);
    addMembers<&Track::dips>(all, *scenario.track);
    addMembers<&Track::bumps>(all, *scenario.track);
    addMembers<&Track::ramps>(all, *scenario.track);
  }
  if (scenario.rig) addSines(all, *scenario.rig);
  return all;
}

}  // namespace vehicle
