#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/definition/part_names.h"
#include "libvehicle/definition/wrong_lines.h"
#include "libvehicle/model/topology.h"

namespace vehicle {

namespace {

const std::string kAnyElement = "<any>";  // no name of a file

/// Finds the parts whose loads are not certain, and makes a vehicle of the rest in which these stand still.
class SoundPart {
 public:
  SoundPart(const Vehicle& vehicle, const ProblemList& problems)
      : vehicle_(vehicle), wrong_(problems), parts_(partsOf(vehicle)), names_(vehicle, parts_) {}

  Topology run() {
    std::set<std::string_view> groups;
    for (const Group& each : vehicle_.groups) {
      if (!isWrong(each)) groups.insert(each.name);
    }
    const auto isLost = [&](const auto& part) {
      return isWrong(part) || (!part.group.empty() && !groups.contains(part.group));
    };
    for (const Body& each : vehicle_.bodies) {
      if (!bodies_.insert(each.name).second || isLost(each)) open_.insert(each.name);
    }
    for (const Wheelset& each : vehicle_.wheelsets) {
      if (!wheelsets_.insert(each.name).second || isLost(each)) open_.insert(each.name);
    }
    std::set<std::string_view> elements;
    for (const Element& each : vehicle_.elements) {
      if (!isWrong(each)) elements.insert(each.name);
    }
    for (const Suspension& each : vehicle_.suspensions) {
      const SuspensionEnds ends = endsOf(each, names_);
      const bool has_element = elements.contains(each.element);
      if (isLost(each) || !exists(each) || (!has_element && !each.preload)) {
        openBy(each, ends);
        continue;
      }
      sound_.push_back(each);
      if (!has_element) sound_.back().element = kAnyElement;  // the load that it is given is all that counts
    }
    openBesideEmptyWheelsets();
    spread();
    return topologyOf(made());
  }

 private:
  /// Whether anything is wrong with the part that its loads depend on; an inertia, a height or a y is not.
  [[nodiscard]] bool isWrong(const auto& part) const {
    constexpr std::array kAsked = {"name",    "group", "mass",       "x",       "x_lower",           "motion",
                                   "element", "upper", "lower",      "preload", "contact_stiffness", "hertz_constant",
                                   "load",    "sides", "stiffness_z"};
    const bool known =
        std::all_of(kAsked.begin(), kAsked.end(), [&](const char* each) { return part.origin.knows(each); });
    return !known || wrong_.touch(part.origin) || names_.isStrange(part.name);
  }

  [[nodiscard]] bool exists(const Suspension& each) const {
    return bodies_.contains(each.upper) && (bodies_.contains(each.lower) || wheelsets_.contains(each.lower));
  }

  /// A suspension that is wrong leaves open what both its ends carry. Where it is not known which body it is, it may be
  /// any that is carried as this suspension carries: by given preloads or by springs.
  void openBy(const Suspension& each, const SuspensionEnds& ends) {
    for (const Meaning& end : {ends.upper, ends.lower}) {
      if (!end.name.empty()) open_.insert(end.name);
    }
    if (!ends.upper.name.empty()) return;
    std::set<std::string_view> like;
    for (const Suspension& other : vehicle_.suspensions) {
      if (other.preload.has_value() == each.preload.has_value()) like.insert(other.upper);
    }
    open_.insert(like.begin(), like.end());
  }

  /// On a wheelset that nothing stands on a spring is missing, which may be that of any body on wheelsets.
  void openBesideEmptyWheelsets() {
    std::set<std::string_view> lowers;
    for (const Suspension& each : vehicle_.suspensions) lowers.insert(each.lower);
    const bool any_empty = std::any_of(vehicle_.wheelsets.begin(), vehicle_.wheelsets.end(),
                                       [&](const Wheelset& each) { return !lowers.contains(each.name); });
    if (!any_empty) return;
    for (const Suspension& each : sound_) {
      if (wheelsets_.contains(each.lower) && !each.preload) open_.insert(each.upper);
    }
  }

  /// What a spring carries depends on both its ends; a given preload does not.
  void spread() {
    std::multimap<std::string_view, std::string_view> neighbours;
    for (const Suspension& each : sound_) {
      if (each.preload) continue;
      neighbours.emplace(each.upper, each.lower);
      neighbours.emplace(each.lower, each.upper);
    }
    std::vector<std::string_view> at_hand(open_.begin(), open_.end());
    while (!at_hand.empty()) {
      const auto [begin, end] = neighbours.equal_range(at_hand.back());
      at_hand.pop_back();
      for (auto each = begin; each != end; ++each) {
        if (open_.insert(each->second).second) at_hand.push_back(each->second);
      }
    }
  }

  [[nodiscard]] Vehicle made() const {
    Vehicle made;
    made.units = vehicle_.units;
    made.elements = vehicle_.elements;
    made.elements.emplace_back().name = kAnyElement;
    made.groups = vehicle_.groups;
    for (Body body : vehicle_.bodies) {
      if (open_.contains(body.name)) still(body);
      made.bodies.push_back(std::move(body));
    }
    for (Wheelset wheelset : vehicle_.wheelsets) {
      if (open_.contains(wheelset.name)) still(wheelset);
      made.wheelsets.push_back(std::move(wheelset));
    }
    made.suspensions = sound_;
    return made;
  }

  static void still(Body& body) {
    body.group.clear();
    body.motion.clear();
  }

  /// A load that is given is not judged.
  static void still(Wheelset& wheelset) {
    wheelset.group.clear();
    wheelset.mass.reset();
    wheelset.load = 0.0;
  }

  const Vehicle& vehicle_;
  WrongLines wrong_;
  std::vector<Part> parts_;
  PartNames names_;
  std::set<std::string_view> bodies_;
  std::set<std::string_view> wheelsets_;
  std::set<std::string_view> open_;  // parts whose loads are not certain
  std::vector<Suspension> sound_;
};

}  // namespace

Topology soundTopologyOf(const Vehicle& vehicle) {
  const ProblemList problems = check(vehicle);
  if (problems.empty() && vehicle.origin.knowsAll() && !vehicle.origin.hasStrange()) {
    bool readable = true;
    for (const Part& each : partsOf(vehicle)) readable = readable && each.place.knowsAll();
    if (readable) return topologyOf(vehicle);
  }
  return SoundPart(vehicle, problems).run();
}

}  // namespace vehicle
