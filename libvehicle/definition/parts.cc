#include "libvehicle/definition/parts.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <set>

#include "libvehicle/definition/judge.h"

namespace vehicle {

namespace {

template <class PartType>
void collect(std::vector<Part>& parts, std::string_view kind, const std::vector<PartType>& from) {
  for (const PartType& part : from) {
    if constexpr (requires { part.group; }) {
      parts.push_back({kind, pathOf(kind, part.group), part.name, part.origin});
    } else {
      parts.push_back({kind, pathOf(kind), part.name, part.origin});
    }
  }
}

/// A part's name as its own vehicle's file has it: in a train the name of its unit stands before it.
std::string ownName(const std::string& name, const std::set<std::string_view>& units) {
  const std::size_t dot = name.find('.');
  const bool in_train = dot != std::string::npos && units.contains(std::string_view(name).substr(0, dot));
  return in_train ? name.substr(dot + 1) : name;
}

void checkNames(const Vehicle& vehicle, const std::vector<Part>& parts, ProblemList& problems) {
  std::set<std::string_view> units;
  for (const TrainUnit& unit : vehicle.units) units.insert(unit.name);
  std::map<std::string_view, const Part*> first;
  for (const Part& part : parts) {
    Judge judge(problems, part.path, part.name, part.place);
    if (!judge.partName(ownName(part.name, units))) continue;
    const auto [entry, fresh] = first.try_emplace(part.name, &part);
    if (fresh) continue;
    const Part& other = *entry->second;
    judge.say(written("name", part.name) + " is already the name of " + withArticle(other.kind) + inLine(other.place),
              "names are unique in a file");
  }
}

/// Looks up what a part refers to; tells what is wrong with it.
class References {
 public:
  References(const std::vector<Part>& parts, ProblemList& problems) : parts_(parts), problems_(problems) {
    for (const Part& part : parts) by_name_.emplace(part.name, &part);
  }

  void expect(const Part& from, std::string_view attribute, const std::string& name,
              std::initializer_list<std::string_view> kinds) {
    const auto fits = [&](const Part& part) { return std::find(kinds.begin(), kinds.end(), part.kind) != kinds.end(); };
    const auto [begin, end] = by_name_.equal_range(name);
    if (std::any_of(begin, end, [&](const auto& entry) { return fits(*entry.second); })) return;
    complete_ = false;
    std::string wanted;
    for (const std::string_view kind : kinds) wanted += (wanted.empty() ? "" : " or ") + withArticle(kind);
    wanted += " is expected";
    Judge judge(problems_, from.path, from.name, from.place);
    if (begin != end) {
      const Part& other = *begin->second;
      judge.say(written(attribute, name) + " is " + withArticle(other.kind) + inLine(other.place), wanted);
      return;
    }
    // Comparing every lost name with every name of a huge file would take minutes; nobody reads so many.
    constexpr int kSuggestions = 20;
    std::vector<std::string> candidates;
    for (const Part& part : parts_) {
      if (suggested_ < kSuggestions && fits(part)) candidates.push_back(part.name);
    }
    ++suggested_;
    const auto nearest = nearestName(name, candidates);
    judge.say(written(attribute, name) + " names no part of this vehicle",
              nearest ? wanted + "; did you mean \"" + *nearest + "\"?" : wanted);
  }

  [[nodiscard]] bool complete() const { return complete_; }

 private:
  const std::vector<Part>& parts_;
  ProblemList& problems_;
  std::multimap<std::string_view, const Part*> by_name_;
  int suggested_ = 0;
  bool complete_ = true;
};

template <class PartType>
Part partOf(std::string_view kind, const PartType& part) {
  return {kind, pathOf(kind, part.group), part.name, part.origin};
}

bool checkReferences(const Vehicle& vehicle, const std::vector<Part>& parts, ProblemList& problems) {
  References references(parts, problems);
  const auto expectGroup = [&](std::string_view kind, const auto& part) {
    if (!part.group.empty()) references.expect(partOf(kind, part), "group", part.group, {"group"});
  };
  for (const Body& body : vehicle.bodies) expectGroup("body", body);
  for (const Wheelset& wheelset : vehicle.wheelsets) expectGroup("wheelset", wheelset);
  for (const Suspension& suspension : vehicle.suspensions) {
    const Part from = partOf("suspension", suspension);
    expectGroup("suspension", suspension);
    references.expect(from, "element", suspension.element, {"element"});
    references.expect(from, "upper", suspension.upper, {"body"});
    references.expect(from, "lower", suspension.lower, {"body", "wheelset"});
  }
  for (const Point& point : vehicle.points) {
    expectGroup("point", point);
    references.expect(partOf("point", point), "body", point.body, {"body"});
  }
  return references.complete();
}

/// What springs hold up. Wheelsets stand by themselves, and so do bodies without the motion z.
std::set<std::string_view> carriedParts(const Vehicle& vehicle) {
  std::vector<std::string_view> standing;
  for (const Wheelset& wheelset : vehicle.wheelsets) standing.push_back(wheelset.name);
  for (const Body& body : vehicle.bodies) {
    if (!moves(body, Motion::kZ)) standing.push_back(body.name);
  }
  std::set<std::string_view> stiff;
  for (const Element& element : vehicle.elements) {
    if (element.stiffness_z > 0.0) stiff.insert(element.name);
  }
  std::multimap<std::string_view, std::string_view> springs;
  for (const Suspension& suspension : vehicle.suspensions) {
    if (!stiff.contains(suspension.element)) continue;
    springs.emplace(suspension.upper, suspension.lower);
    springs.emplace(suspension.lower, suspension.upper);
  }
  std::set<std::string_view> carried;
  while (!standing.empty()) {
    const std::string_view part = standing.back();
    standing.pop_back();
    if (!carried.insert(part).second) continue;
    const auto [begin, end] = springs.equal_range(part);
    for (auto spring = begin; spring != end; ++spring) standing.push_back(spring->second);
  }
  return carried;
}

void checkCarried(const Vehicle& vehicle, ProblemList& problems) {
  const std::set<std::string_view> carried = carriedParts(vehicle);
  std::set<std::string_view> lowers;
  for (const Suspension& suspension : vehicle.suspensions) lowers.insert(suspension.lower);
  for (const Body& body : vehicle.bodies) {
    if (carried.contains(body.name)) continue;
    Judge(problems, pathOf("body", body.group), body.name, body.origin)
        .say('"' + body.name + "\" stands on nothing: no chain of springs leads from it down to a wheelset",
             "add a <suspension> under it whose element has stiffness_z > 0");
  }
  for (const Wheelset& wheelset : vehicle.wheelsets) {
    if (lowers.contains(wheelset.name)) continue;
    Judge(problems, pathOf("wheelset", wheelset.group), wheelset.name, wheelset.origin)
        .say("nothing stands on \"" + wheelset.name + "\": no <suspension> names it as its lower",
             "add the <suspension>, or remove the wheelset");
  }
}

}  // namespace

std::vector<Part> partsOf(const Vehicle& vehicle) {
  std::vector<Part> parts;
  collect(parts, "element", vehicle.elements);
  collect(parts, "group", vehicle.groups);
  collect(parts, "body", vehicle.bodies);
  collect(parts, "wheelset", vehicle.wheelsets);
  collect(parts, "suspension", vehicle.suspensions);
  collect(parts, "point", vehicle.points);
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Part& a, const Part& b) { return a.place.line < b.place.line; });
  return parts;
}

std::string pathOf(std::string_view kind, std::string_view group) {
  return (group.empty() ? "<vehicle><" : "<vehicle><group><") + std::string(kind) + '>';
}

std::string withArticle(std::string_view kind) { return (kind.front() == 'e' ? "an " : "a ") + std::string(kind); }

ProblemList checkTies(const Vehicle& vehicle) {
  ProblemList problems;
  const std::vector<Part> parts = partsOf(vehicle);
  checkNames(vehicle, parts, problems);
  if (checkReferences(vehicle, parts, problems)) checkCarried(vehicle, problems);
  return problems;
}

}  // namespace vehicle
