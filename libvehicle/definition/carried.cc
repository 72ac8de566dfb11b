#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "libvehicle/definition/judge.h"
#include "libvehicle/definition/part_names.h"

// What stands on what.
namespace vehicle {

namespace {

/// A spring between two parts; "" where the file leaves open which.
struct Spring {
  std::string_view upper;
  std::string_view lower;
};

/// Whether suspensions may name it at all.
bool isNamed(const auto& part) { return !part.name.empty() && part.origin.knows("name"); }

/// Suspensions that may carry something: those whose stiffness is not known may, too.
std::vector<Spring> springsOf(const Vehicle& vehicle, const PartNames& names) {
  std::set<std::string_view> soft;
  for (const Element& element : vehicle.elements) {
    if (!(element.stiffness_z > 0.0) && element.origin.knows("stiffness_z")) soft.insert(element.name);
  }
  std::vector<Spring> springs;
  for (const Suspension& each : vehicle.suspensions) {
    const SuspensionEnds ends = endsOf(each, names);
    if (!soft.contains(ends.element.name)) springs.push_back({ends.upper.name, ends.lower.name});
  }
  return springs;
}

class Carried {
 public:
  Carried(const Vehicle& vehicle, const PartNames& names) : vehicle_(vehicle) {
    std::vector<std::string_view> standing;
    for (const Wheelset& wheelset : vehicle.wheelsets) standing.push_back(wheelset.name);
    // Bodies without the motion z stand by themselves.
    for (const Body& body : vehicle.bodies) {
      const bool falls = moves(body, Motion::kZ) && body.origin.knows("motion") && !names.isStrange(body.name);
      if (!falls) standing.push_back(body.name);
    }
    for (const Spring& spring : springsOf(vehicle, names)) {
      // A spring whose other end is not known may stand on something.
      if (spring.lower.empty()) standing.push_back(spring.upper);
      if (spring.upper.empty() || spring.lower.empty()) continue;
      neighbours_.emplace(spring.upper, spring.lower);
      neighbours_.emplace(spring.lower, spring.upper);
      below_.emplace(spring.upper, spring.lower);
    }
    spread(std::move(standing), carried_);
  }

  /// The bodies to be reported: of those that hang together the ones that have nothing at all below them.
  std::vector<const Body*> loose() const {
    std::vector<const Body*> found;
    std::set<std::string_view> reported;
    for (const bool ends_only : {true, false}) {
      for (const Body& body : vehicle_.bodies) {
        if (carried_.contains(body.name) || reported.contains(body.name) || !isNamed(body)) continue;
        if (ends_only && below_.contains(body.name)) continue;
        found.push_back(&body);
        spread({body.name}, reported);
      }
    }
    return found;
  }

 private:
  /// Adds what springs lead to.
  void spread(std::vector<std::string_view> from, std::set<std::string_view>& reached) const {
    while (!from.empty()) {
      const std::string_view part = from.back();
      from.pop_back();
      if (!reached.insert(part).second) continue;
      const auto [begin, end] = neighbours_.equal_range(part);
      for (auto each = begin; each != end; ++each) from.push_back(each->second);
    }
  }

  const Vehicle& vehicle_;
  std::multimap<std::string_view, std::string_view> neighbours_;
  std::multimap<std::string_view, std::string_view> below_;
  std::set<std::string_view> carried_;
};

void checkStoodOn(const Vehicle& vehicle, const PartNames& names, ProblemList& problems) {
  std::set<std::string_view> lowers;
  std::size_t open = 0;  // suspensions that may stand on any wheelset
  for (const Suspension& each : vehicle.suspensions) {
    const Meaning lower = endsOf(each, names).lower;
    if (lower.name.empty()) {
      ++open;
    } else {
      lowers.insert(lower.name);
    }
  }
  std::vector<const Wheelset*> empty;
  for (const Wheelset& each : vehicle.wheelsets) {
    if (!lowers.contains(each.name) && isNamed(each) && !names.isStrange(each.name)) empty.push_back(&each);
  }
  if (empty.size() <= open) return;
  for (const Wheelset* each : empty) {
    Judge(problems, pathOf("wheelset", each->group), each->name, each->origin)
        .say("nothing stands on \"" + each->name + "\": no <suspension> names it as its lower",
             "add the <suspension>, or remove the wheelset");
  }
}

}  // namespace

ProblemList checkCarried(const Vehicle& vehicle, const PartNames& names) {
  ProblemList problems;
  // Without any of a kind everything would stand on nothing; that is reported once, of the whole.
  if (vehicle.bodies.empty() || vehicle.wheelsets.empty() || vehicle.suspensions.empty()) return problems;
  for (const Body* body : Carried(vehicle, names).loose()) {
    Judge(problems, pathOf("body", body->group), body->name, body->origin)
        .say('"' + body->name + "\" stands on nothing: no chain of springs leads from it down to a wheelset",
             "add a <suspension> under it whose element has stiffness_z > 0");
  }
  checkStoodOn(vehicle, names, problems);
  return problems;
}

}  // namespace vehicle
