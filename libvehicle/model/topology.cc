#include "libvehicle/model/topology.h"

#include <cassert>
#include <map>
#include <string_view>

namespace vehicle {

namespace {

/// Place of each name in the list it stands in; check() has made sure that every reference is found.
template <class Part>
std::map<std::string_view, int> placesOf(const std::vector<Part>& parts) {
  std::map<std::string_view, int> places;
  for (const Part& part : parts) places.emplace(part.name, static_cast<int>(places.size()));
  return places;
}

int placeIn(const std::map<std::string_view, int>& places, const std::string& name) {
  const auto found = places.find(name);
  return found == places.end() ? -1 : found->second;
}

class Builder {
 public:
  explicit Builder(const Vehicle& vehicle)
      : vehicle_(vehicle),
        elements_(placesOf(vehicle.elements)),
        bodies_(placesOf(vehicle.bodies)),
        wheelsets_(placesOf(vehicle.wheelsets)) {
    for (const Group& group : vehicle.groups) group_x_.emplace(group.name, group.x);
  }

  Topology build() {
    topology_.name = vehicle_.name;
    topology_.origin = vehicle_.origin;
    topology_.units = vehicle_.units.size();
    for (const Body& body : vehicle_.bodies) addBody(body);
    for (const Wheelset& wheelset : vehicle_.wheelsets) addWheelset(wheelset);
    for (const Suspension& suspension : vehicle_.suspensions) addSuspension(suspension);
    for (const Point& point : vehicle_.points) {
      const int body = placeIn(bodies_, point.body);
      topology_.points.push_back({point.name, body, absolute(point) - bodyAt(body).x});
    }
    return topology_;
  }

 private:
  template <class Part>
  [[nodiscard]] double absolute(const Part& part) const {
    return part.group.empty() ? part.x : group_x_.at(part.group) + part.x;
  }

  [[nodiscard]] double lowerEnd(const Suspension& suspension) const {
    if (!suspension.x_lower) return absolute(suspension);
    return suspension.group.empty() ? *suspension.x_lower : group_x_.at(suspension.group) + *suspension.x_lower;
  }

  [[nodiscard]] const TopologyBody& bodyAt(int place) const {
    assert(place >= 0);  // check() has found every reference
    return topology_.bodies[static_cast<std::size_t>(place)];
  }

  void addBody(const Body& body) {
    TopologyBody made;
    made.name = body.name;
    made.origin = body.origin;
    made.mass = body.mass;
    made.pitch_inertia = body.pitch_inertia.value_or(0.0);
    made.x = absolute(body);
    made.z = body.z.value_or(0.0);
    if (moves(body, Motion::kZ)) made.z_index = topology_.coordinates++;
    if (moves(body, Motion::kPitch)) made.pitch_index = topology_.coordinates++;
    // Heights are given for all parts or for none.
    topology_.has_heights = topology_.has_heights || body.z.has_value();
    topology_.bodies.push_back(made);
  }

  void addWheelset(const Wheelset& wheelset) {
    TopologyWheelset made;
    made.name = wheelset.name;
    made.origin = wheelset.origin;
    made.x = absolute(wheelset);
    made.z = wheelset.z.value_or(0.0);
    made.mass = wheelset.mass.value_or(0.0);
    made.contact_damping = wheelset.contact_damping.value_or(0.0);
    made.load = wheelset.load;
    made.contact_stiffness = wheelset.contact_stiffness;
    made.hertz_constant = wheelset.hertz_constant;
    if (hasOwnMotion(wheelset)) made.z_index = topology_.coordinates++;
    topology_.wheelsets.push_back(made);
  }

  void addSuspension(const Suspension& suspension) {
    const auto& element = vehicle_.elements[static_cast<std::size_t>(placeIn(elements_, suspension.element))];
    TopologySuspension made;
    made.name = suspension.name;
    made.origin = suspension.origin;
    made.stiffness = suspension.sides * element.stiffness_z;
    made.damping = suspension.sides * element.damping_z;
    made.x = absolute(suspension);
    made.preload = suspension.preload;
    made.upper = placeIn(bodies_, suspension.upper);
    const TopologyBody& upper = bodyAt(made.upper);
    made.arm_upper = made.x - upper.x;
    made.height_upper = suspension.z_upper.value_or(upper.z) - upper.z;
    made.lower_body = placeIn(bodies_, suspension.lower);
    if (made.lower_body >= 0) {
      const TopologyBody& lower = bodyAt(made.lower_body);
      made.arm_lower = lowerEnd(suspension) - lower.x;
      made.height_lower = suspension.z_lower.value_or(lower.z) - lower.z;
    } else {
      made.lower_wheelset = placeIn(wheelsets_, suspension.lower);
      assert(made.lower_wheelset >= 0);  // check() has found every reference
      // The axle's height is optional even where heights are given; without it the end sits on the axle.
      const auto& lower = vehicle_.wheelsets[static_cast<std::size_t>(made.lower_wheelset)];
      if (lower.z) made.height_lower = suspension.z_lower.value_or(*lower.z) - *lower.z;
    }
    topology_.suspensions.push_back(made);
  }

  const Vehicle& vehicle_;
  std::map<std::string_view, int> elements_;
  std::map<std::string_view, int> bodies_;
  std::map<std::string_view, int> wheelsets_;
  std::map<std::string_view, double> group_x_;
  Topology topology_;
};

}  // namespace

Topology topologyOf(const Vehicle& vehicle) { return Builder(vehicle).build(); }

}  // namespace vehicle
