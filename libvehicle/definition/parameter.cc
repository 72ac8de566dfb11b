#include "libvehicle/definition/parameter.h"

#include <type_traits>

namespace vehicle {

namespace {

using enum Dimension;

// The attributes that count as parameters are listed here a second time, after the schema table of `xml`, which this
// room may not see; the test XmlParameters.* holds the two lists equal, names and dimensions.

template <class Part>
std::optional<double> numberIn(const Part& part, auto member) {
  return part.*member;
}

/// One attribute of all parts of a kind: kParts is Vehicle's list, kMember the part's number.
template <auto kParts, auto kMember>
void add(std::vector<VehicleParameter>& to, const Vehicle& vehicle, std::string_view attribute, Dimension dimension) {
  for (std::size_t i = 0; i < (vehicle.*kParts).size(); ++i) {
    to.push_back({(vehicle.*kParts)[i].name + '.' + std::string(attribute), dimension, i,
                  [](const Vehicle& owner, std::size_t index) { return numberIn((owner.*kParts)[index], kMember); },
                  [](Vehicle& owner, std::size_t index, double si) { (owner.*kParts)[index].*kMember = si; }});
  }
}

/// The same for the named members of a track.
template <auto kMembers, auto kMember>
void addMember(std::vector<ScenarioParameter>& to, const Scenario& scenario, std::string_view attribute,
               Dimension dimension) {
  if (!scenario.track) return;
  const auto& members = (*scenario.track).*kMembers;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i].name.empty()) continue;
    to.push_back(
        {"scenario." + members[i].name + '.' + std::string(attribute), dimension, i,
         [](const Scenario& owner, std::size_t index) { return numberIn(((*owner.track).*kMembers)[index], kMember); },
         [](Scenario& owner, std::size_t index, double si) { ((*owner.track).*kMembers)[index].*kMember = si; }});
  }
}

/// The sine of that number, counted through all inputs of the rig.
template <class Owner>
auto& sineIn(Owner& scenario, std::size_t index) {
  std::size_t input = 0;
  for (; index >= scenario.rig->inputs[input].sines.size(); ++input) index -= scenario.rig->inputs[input].sines.size();
  return scenario.rig->inputs[input].sines[index];
}

/// One attribute of all named sines of a rig.
template <auto kMember>
void addSine(std::vector<ScenarioParameter>& to, const Scenario& scenario, std::string_view attribute,
             Dimension dimension) {
  if (!scenario.rig) return;
  std::size_t index = 0;
  for (const RigInput& input : scenario.rig->inputs) {
    for (const RigSine& sine : input.sines) {
      const std::size_t own = index++;
      if (sine.name.empty()) continue;
      to.push_back({"scenario." + sine.name + '.' + std::string(attribute), dimension, own,
                    [](const Scenario& owner, std::size_t place) { return numberIn(sineIn(owner, place), kMember); },
                    [](Scenario& owner, std::size_t place, double si) { sineIn(owner, place).*kMember = si; }});
    }
  }
}

template <auto kMember>
ScenarioParameter ofRun(std::string_view address, Dimension dimension) {
  return {std::string(address), dimension, 0,
          [](const Scenario& owner, std::size_t) { return numberIn(owner.run, kMember); },
          [](Scenario& owner, std::size_t, double si) { owner.run.*kMember = si; }};
}

}  // namespace

std::vector<VehicleParameter> parametersOf(const Vehicle& vehicle) {
  std::vector<VehicleParameter> all;
  add<&Vehicle::elements, &Element::stiffness_z>(all, vehicle, "stiffness_z", kStiffness);
  add<&Vehicle::elements, &Element::damping_z>(all, vehicle, "damping_z", kDamping);
  add<&Vehicle::groups, &Group::x>(all, vehicle, "x", kLength);
  add<&Vehicle::bodies, &Body::mass>(all, vehicle, "mass", kMass);
  add<&Vehicle::bodies, &Body::pitch_inertia>(all, vehicle, "pitch_inertia", kInertia);
  add<&Vehicle::bodies, &Body::x>(all, vehicle, "x", kLength);
  add<&Vehicle::bodies, &Body::z>(all, vehicle, "z", kLength);
  add<&Vehicle::wheelsets, &Wheelset::x>(all, vehicle, "x", kLength);
  add<&Vehicle::wheelsets, &Wheelset::z>(all, vehicle, "z", kLength);
  add<&Vehicle::wheelsets, &Wheelset::mass>(all, vehicle, "mass", kMass);
  add<&Vehicle::wheelsets, &Wheelset::load>(all, vehicle, "load", kForce);
  add<&Vehicle::wheelsets, &Wheelset::contact_stiffness>(all, vehicle, "contact_stiffness", kStiffness);
  add<&Vehicle::wheelsets, &Wheelset::contact_damping>(all, vehicle, "contact_damping", kDamping);
  add<&Vehicle::wheelsets, &Wheelset::hertz_constant>(all, vehicle, "hertz_constant", kHertzConstant);
  add<&Vehicle::suspensions, &Suspension::x>(all, vehicle, "x", kLength);
  add<&Vehicle::suspensions, &Suspension::z_upper>(all, vehicle, "z_upper", kLength);
  add<&Vehicle::suspensions, &Suspension::z_lower>(all, vehicle, "z_lower", kLength);
  add<&Vehicle::suspensions, &Suspension::y>(all, vehicle, "y", kLength);
  add<&Vehicle::suspensions, &Suspension::preload>(all, vehicle, "preload", kForce);
  add<&Vehicle::points, &Point::x>(all, vehicle, "x", kLength);
  return all;
}

std::vector<ScenarioParameter> parametersOf(const Scenario& scenario) {
  std::vector<ScenarioParameter> all;
  all.push_back(ofRun<&Run::speed>("speed", kSpeed));
  all.push_back({"scenario.gravity", kAcceleration, 0,
                 [](const Scenario& owner, std::size_t) { return std::optional<double>(owner.gravity); },
                 [](Scenario& owner, std::size_t, double si) { owner.gravity = si; }});
  all.push_back(ofRun<&Run::duration>("scenario.duration", kTime));
  all.push_back(ofRun<&Run::distance>("scenario.distance", kLength));
  all.push_back(ofRun<&Run::output_step>("scenario.output_step", kTime));
  if (scenario.track) {
    all.push_back({"scenario.fade_in", kLength, 0,
                   [](const Scenario& owner, std::size_t) { return owner.track->fade_in; },
                   [](Scenario& owner, std::size_t, double si) { owner.track->fade_in = si; }});
  }
  addMember<&Track::harmonics, &Harmonic::wavelength>(all, scenario, "wavelength", kLength);
  addMember<&Track::harmonics, &Harmonic::order>(all, scenario, "order", kNumber);
  addMember<&Track::harmonics, &Harmonic::amplitude>(all, scenario, "amplitude", kLength);
  addMember<&Track::harmonics, &Harmonic::phase>(all, scenario, "phase", kAngle);
  addMember<&Track::dips, &Dip::depth>(all, scenario, "depth", kLength);
  addMember<&Track::dips, &Dip::length>(all, scenario, "length", kLength);
  addMember<&Track::dips, &Dip::start>(all, scenario, "start", kLength);
  addMember<&Track::bumps, &Bump::height>(all, scenario, "height", kLength);
  addMember<&Track::bumps, &Bump::length>(all, scenario, "length", kLength);
  addMember<&Track::bumps, &Bump::start>(all, scenario, "start", kLength);
  addMember<&Track::ramps, &Ramp::rise>(all, scenario, "rise", kLength);
  addMember<&Track::ramps, &Ramp::length>(all, scenario, "length", kLength);
  addMember<&Track::ramps, &Ramp::start>(all, scenario, "start", kLength);
  addSine<&RigSine::amplitude>(all, scenario, "amplitude", kLength);
  addSine<&RigSine::angular_frequency>(all, scenario, "angular_frequency", kAngularVelocity);
  addSine<&RigSine::frequency>(all, scenario, "frequency", kFrequency);
  addSine<&RigSine::phase>(all, scenario, "phase", kAngle);
  return all;
}

}  // namespace vehicle
