#include "libvehicle/definition/vehicle.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "libvehicle/definition/judge.h"
#include "libvehicle/definition/parts.h"
#include "libvehicle/definition/vehicle_attributes.h"

namespace vehicle {

std::string_view nameOf(Motion motion) {
  switch (motion) {
    case Motion::kX: return "x";
    case Motion::kY: return "y";
    case Motion::kZ: return "z";
    case Motion::kRoll: return "roll";
    case Motion::kPitch: return "pitch";
    case Motion::kYaw: return "yaw";
  }
  return "";
}

namespace {

using enum Dimension;

void checkMotion(const Body& body, Judge& judge) {
  if (!judge.knows({"motion"})) return;
  if (body.motion.empty()) judge.say("motion is empty", "name the motions the body has, e.g. motion=\"z pitch\"");
  std::set<Motion> seen;
  std::set<Motion> told;
  for (const Motion motion : body.motion) {
    if (seen.insert(motion).second || !told.insert(motion).second) continue;
    judge.say("motion names \"" + std::string(nameOf(motion)) + "\" twice", "name each motion once");
  }
}

void checkBody(const Body& body, ProblemList& problems) {
  Judge judge(problems, pathOf("body", body.group), body.name, body.origin);
  judge.numbers<&Body::pitch_inertia>(body);
  checkMotion(body, judge);
  const bool pitches = moves(body, Motion::kPitch) && judge.knows({"motion"});
  if (!pitches) {
    judge.number<&Body::pitch_inertia>(body);
  } else if (body.pitch_inertia) {
    judge.positive("pitch_inertia", body.pitch_inertia, kInertia);
  } else if (judge.knows({"pitch_inertia"})) {
    judge.say("pitches (motion names \"pitch\") without pitch_inertia", "give it, e.g. pitch_inertia=\"70 t*m^2\"");
  }
}

void checkWheelset(const Wheelset& wheelset, ProblemList& problems) {
  Judge judge(problems, pathOf("wheelset", wheelset.group), wheelset.name, wheelset.origin);
  judge.numbers(wheelset);
  const bool spring = wheelset.contact_stiffness || wheelset.hertz_constant;
  if (wheelset.contact_stiffness && wheelset.hertz_constant) {
    judge.say("has contact_stiffness and hertz_constant", "give one of them: the contact is linear or Hertz's");
  }
  if (spring && !wheelset.mass && judge.knows({"mass"})) {
    const std::string given = wheelset.contact_stiffness ? "contact_stiffness" : "hertz_constant";
    judge.say("has " + given + " but no mass",
              "give its mass, or leave the contact out: then it follows the rail");
  }
  if (wheelset.contact_damping && !spring && judge.knows({"contact_stiffness", "hertz_constant"})) {
    judge.say("has contact_damping but no contact spring",
              "give contact_stiffness or hertz_constant, or leave contact_damping out");
  }
}

void checkSuspension(const Suspension& suspension, ProblemList& problems) {
  Judge judge(problems, pathOf("suspension", suspension.group), suspension.name, suspension.origin);
  judge.number<&Suspension::x>(suspension);
  judge.finite("x_lower", suspension.x_lower, kLength);  // of a coupling: no file gives it
  judge.numbers<&Suspension::x>(suspension);
  if (judge.knows({"sides"})) {
    if (suspension.sides != 1 && suspension.sides != 2) {
      judge.say(judge.written("sides", suspension.sides), "must be 1 or 2");
    }
    if (suspension.sides == 2 && !suspension.y && judge.knows({"y"})) {
      judge.say("sides=\"2\" without y", "give y, half the distance across the track, e.g. y=\"1 m\"");
    }
  }
  if (!suspension.upper.empty() && suspension.upper == suspension.lower && judge.knows({"upper", "lower"})) {
    judge.say("upper and lower are both \"" + suspension.upper + '"', "a suspension joins two parts");
  }
}

/// A part as far as its heights go.
struct Heights {
  std::string_view kind;
  const std::string& name;
  const std::string& group;
  const Origin& origin;
  std::string missing;  // "z_upper"; "" where it has all it needs

  [[nodiscard]] std::string quoted() const {
    return "the " + std::string(kind) + " \"" + name + '"' + inLine(origin);
  }
};

/// Heights are given everywhere or nowhere: a body whose height is unknown has no lever arm for gravity. However many
/// parts differ, that is one mistake: of the fewer, those that have heights or those that lack them.
void checkHeights(const Vehicle& vehicle, ProblemList& problems) {
  std::vector<Heights> with;
  std::vector<Heights> without;
  for (const Body& each : vehicle.bodies) {
    if (each.z) with.push_back({"body", each.name, each.group, each.origin, ""});
    if (!each.z && each.origin.knows("z")) without.push_back({"body", each.name, each.group, each.origin, "z"});
  }
  for (const Wheelset& each : vehicle.wheelsets) {
    if (each.z) with.push_back({"wheelset", each.name, each.group, each.origin, ""});
  }
  for (const Suspension& each : vehicle.suspensions) {
    const Heights heights{"suspension", each.name, each.group, each.origin, ""};
    if (each.z_upper || each.z_lower) with.push_back(heights);
    if ((each.z_upper && each.z_lower) || !each.origin.knows("z_upper") || !each.origin.knows("z_lower")) continue;
    without.push_back(heights);
    without.back().missing = each.z_upper ? "z_lower" : each.z_lower ? "z_upper" : "z_upper and no z_lower";
  }
  if (with.empty() || without.empty()) return;
  const auto firstOf = [](const std::vector<Heights>& parts) {
    return std::min_element(parts.begin(), parts.end(),
                            [](const Heights& a, const Heights& b) { return a.origin.line < b.origin.line; });
  };
  const bool few_have = with.size() < without.size();
  const std::vector<Heights>& wrong = few_have ? with : without;
  const Heights& first = *firstOf(wrong);
  const Heights& other = *firstOf(few_have ? without : with);
  std::vector<Place> others;
  for (const Heights& each : wrong) {
    if (&each != &first) others.push_back(each.origin);
  }
  std::stable_sort(others.begin(), others.end(), [](const Place& a, const Place& b) { return a.line < b.line; });
  const std::string is = few_have ? "has a height" : "has no " + first.missing;
  const std::string is_not = few_have ? " has no " + other.missing : " has a height";
  Judge(problems, pathOf(first.kind, first.group), first.name, first.origin)
      .say(is + andIn(others) + ", but " + other.quoted() + is_not,
           "heights are given for all bodies and both ends of all suspensions, or for none");
}

void checkWhole(const Vehicle& vehicle, ProblemList& problems) {
  Judge judge(problems, "<vehicle>", vehicle.name, vehicle.origin);
  judge.properName(vehicle.name);
  if (!vehicle.origin.hasStrange()) {
    if (vehicle.bodies.empty()) judge.say("has no <body>", "a vehicle has at least one");
    if (vehicle.wheelsets.empty()) judge.say("has no <wheelset>", "a vehicle has at least one");
    if (vehicle.suspensions.empty()) judge.say("has no <suspension>", "bodies stand on suspensions");
  }
  const bool any = std::any_of(vehicle.bodies.begin(), vehicle.bodies.end(), [](const Body& body) {
    return body.motion.empty() || moves(body, Motion::kZ) || moves(body, Motion::kPitch) ||
           !body.origin.knows("motion");
  });
  if (!vehicle.bodies.empty() && !any && !vehicle.origin.hasStrange()) {
    judge.say("no body has the motion z or pitch", "let at least one move in the vertical plane, e.g. motion=\"z\"");
  }
}

}  // namespace

bool moves(const Body& body, Motion motion) {
  return std::find(body.motion.begin(), body.motion.end(), motion) != body.motion.end();
}

bool hasOwnMotion(const Wheelset& wheelset) {
  return wheelset.mass && (wheelset.contact_stiffness || wheelset.hertz_constant);
}

ProblemList check(const Vehicle& vehicle) {
  ProblemList problems;
  checkWhole(vehicle, problems);
  for (const Element& element : vehicle.elements) {
    Judge(problems, pathOf("element"), element.name, element.origin).numbers(element);
  }
  for (const Group& group : vehicle.groups) {
    Judge(problems, pathOf("group"), group.name, group.origin).numbers(group);
  }
  for (const Body& body : vehicle.bodies) checkBody(body, problems);
  for (const Wheelset& wheelset : vehicle.wheelsets) checkWheelset(wheelset, problems);
  for (const Suspension& suspension : vehicle.suspensions) checkSuspension(suspension, problems);
  for (const Point& point : vehicle.points) {
    Judge(problems, pathOf("point", point.group), point.name, point.origin).numbers(point);
  }
  checkHeights(vehicle, problems);
  problems.append(checkTies(vehicle));
  problems.sortByPlace();
  return problems;
}

}  // namespace vehicle
