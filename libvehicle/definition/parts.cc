#include "libvehicle/definition/parts.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "libvehicle/definition/judge.h"
#include "libvehicle/definition/part_names.h"

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

/// References that lead nowhere or to the wrong kind. A name that is missing is one mistake, however often it is used.
class References {
 public:
  References(const PartNames& names, ProblemList& problems) : names_(names), problems_(problems) {}

  void expect(std::string_view kind, const auto& part, std::string_view attribute, const std::string& name,
              PartNames::Kinds kinds) {
    const Meaning meaning = names_.meaningOf(part.origin, attribute, name, kinds);
    if (meaning.kind == Meaning::Kind::kExact || meaning.kind == Meaning::Kind::kNotKnown) return;
    const bool wrong_kind = meaning.kind == Meaning::Kind::kWrongKind;
    const auto [found, is_new] = places_.try_emplace(wrong_kind ? name + ' ' + std::string(attribute) : name, lost_.size());
    if (!is_new) {
      lost_[found->second].others.push_back(part.origin);
      return;
    }
    std::string wanted;
    for (const std::string_view each : kinds) wanted += (wanted.empty() ? "" : " or ") + withArticle(each);
    Lost lost{pathOf(kind, part.group), part.name, part.origin, written(attribute, name), wanted + " is expected", {}};
    if (wrong_kind) {
      lost.message += " is " + withArticle(meaning.other->kind) + inLine(meaning.other->place);
    } else {
      lost.message += " names no part of this vehicle";
      if (!meaning.name.empty()) lost.remedy += "; did you mean \"" + std::string(meaning.name) + "\"?";
    }
    lost_.push_back(std::move(lost));
  }

  void report() {
    for (const Lost& each : lost_) {
      Judge(problems_, each.path, each.name, each.origin).say(each.message + andIn(each.others), each.remedy);
    }
  }

 private:
  struct Lost {
    std::string path;
    std::string name;
    Origin origin;
    std::string message;
    std::string remedy;
    std::vector<Place> others;
  };

  const PartNames& names_;
  ProblemList& problems_;
  std::map<std::string, std::size_t> places_;  // of the lost names in lost_
  std::vector<Lost> lost_;
};

void checkReferences(const Vehicle& vehicle, const PartNames& names, ProblemList& problems) {
  References references(names, problems);
  const auto expectGroup = [&](std::string_view kind, const auto& part) {
    if (!part.group.empty()) references.expect(kind, part, "group", part.group, {"group"});
  };
  for (const Body& body : vehicle.bodies) expectGroup("body", body);
  for (const Wheelset& wheelset : vehicle.wheelsets) expectGroup("wheelset", wheelset);
  for (const Suspension& suspension : vehicle.suspensions) {
    expectGroup("suspension", suspension);
    references.expect("suspension", suspension, "element", suspension.element, {"element"});
    references.expect("suspension", suspension, "upper", suspension.upper, {"body"});
    references.expect("suspension", suspension, "lower", suspension.lower, {"body", "wheelset"});
  }
  for (const Point& point : vehicle.points) {
    expectGroup("point", point);
    references.expect("point", point, "body", point.body, {"body"});
  }
  references.report();
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
  const PartNames names(vehicle, parts);
  checkNames(vehicle, parts, problems);
  checkReferences(vehicle, names, problems);
  problems.append(checkCarried(vehicle, names));
  return problems;
}

}  // namespace vehicle
