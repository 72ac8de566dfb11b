#include "libvehicle/definition/vehicle.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "libvehicle/definition/judge.h"
#include "libvehicle/definition/parts.h"

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
  judge.positive("mass", body.mass, kMass);
  judge.finite("x", body.x, kLength);
  judge.finite("z", body.z, kLength);
  checkMotion(body, judge);
  if (!moves(body, Motion::kPitch)) {
    judge.notNegative("pitch_inertia", body.pitch_inertia, kInertia);
  } else if (!body.pitch_inertia) {
    judge.say("pitches (motion names \"pitch\") without pitch_inertia", "give it, e.g. pitch_inertia=\"70 t*m^2\"");
  } else {
    judge.positive("pitch_inertia", body.pitch_inertia, kInertia);
  }
}

void checkWheelset(const Wheelset& wheelset, ProblemList& problems) {
  Judge judge(problems, pathOf("wheelset", wheelset.group), wheelset.name, wheelset.origin);
  judge.finite("x", wheelset.x, kLength);
  judge.finite("z", wheelset.z, kLength);
  judge.positive("mass", wheelset.mass, kMass);
  judge.positive("load", wheelset.load, kForce);
  judge.positive("contact_stiffness", wheelset.contact_stiffness, kStiffness);
  judge.notNegative("contact_damping", wheelset.contact_damping, kDamping);
  judge.positive("hertz_constant", wheelset.hertz_constant, kHertzConstant);
  const bool spring = wheelset.contact_stiffness || wheelset.hertz_constant;
  if (wheelset.contact_stiffness && wheelset.hertz_constant) {
    judge.say("has contact_stiffness and hertz_constant", "give one of them: the contact is linear or Hertz's");
  }
  if (spring && !wheelset.mass) {
    const std::string given = wheelset.contact_stiffness ? "contact_stiffness" : "hertz_constant";
    judge.say("has " + given + " but no mass",
              "give its mass, or leave the contact out: then it follows the rail");
  }
  if (wheelset.contact_damping && !spring) {
    judge.say("has contact_damping but no contact spring",
              "give contact_stiffness or hertz_constant, or leave contact_damping out");
  }
}

void checkSuspension(const Suspension& suspension, ProblemList& problems) {
  Judge judge(problems, pathOf("suspension", suspension.group), suspension.name, suspension.origin);
  judge.finite("x", suspension.x, kLength);
  judge.finite("x_lower", suspension.x_lower, kLength);
  judge.finite("z_upper", suspension.z_upper, kLength);
  judge.finite("z_lower", suspension.z_lower, kLength);
  judge.finite("y", suspension.y, kLength);
  judge.finite("preload", suspension.preload, kForce);
  if (suspension.sides != 1 && suspension.sides != 2) {
    judge.say(written("sides", std::to_string(suspension.sides)), "must be 1 or 2");
  }
  if (suspension.sides == 2 && !suspension.y) {
    judge.say("sides=\"2\" without y", "give y, half the distance across the track, e.g. y=\"1 m\"");
  }
  if (!suspension.upper.empty() && suspension.upper == suspension.lower) {
    judge.say("upper and lower are both \"" + suspension.upper + '"', "a suspension joins two parts");
  }
}

/// Heights are given everywhere or nowhere: a body whose height is unknown has no lever arm for gravity.
void checkHeights(const Vehicle& vehicle, ProblemList& problems) {
  std::string where;  // the first part, in file order, that has a height
  int first_line = 0;
  const auto see = [&](std::string_view kind, const std::string& name, const Origin& origin, bool given) {
    if (!given || (!where.empty() && origin.line >= first_line)) return;
    where = "the " + std::string(kind) + " \"" + name + '"' + inLine(origin);
    first_line = origin.line;
  };
  for (const Body& body : vehicle.bodies) see("body", body.name, body.origin, body.z.has_value());
  for (const Wheelset& wheelset : vehicle.wheelsets) {
    see("wheelset", wheelset.name, wheelset.origin, wheelset.z.has_value());
  }
  for (const Suspension& each : vehicle.suspensions) {
    see("suspension", each.name, each.origin, each.z_upper || each.z_lower);
  }
  if (where.empty()) return;
  const std::string other = ", but " + where + " has a height";
  const std::string remedy = "heights are given for all bodies and both ends of all suspensions, or for none";
  for (const Body& body : vehicle.bodies) {
    if (body.z) continue;
    Judge(problems, pathOf("body", body.group), body.name, body.origin).say("has no z" + other, remedy);
  }
  for (const Suspension& each : vehicle.suspensions) {
    if (each.z_upper && each.z_lower) continue;
    const std::string missing = each.z_upper ? "z_lower" : each.z_lower ? "z_upper" : "z_upper and no z_lower";
    Judge(problems, pathOf("suspension", each.group), each.name, each.origin).say("has no " + missing + other, remedy);
  }
}

void checkWhole(const Vehicle& vehicle, ProblemList& problems) {
  Judge judge(problems, "<vehicle>", vehicle.name, vehicle.origin);
  judge.properName(vehicle.name);
  if (vehicle.bodies.empty()) judge.say("has no <body>", "a vehicle has at least one");
  if (vehicle.wheelsets.empty()) judge.say("has no <wheelset>", "a vehicle has at least one");
  if (vehicle.suspensions.empty()) judge.say("has no <suspension>", "bodies stand on suspensions");
  const bool any = std::any_of(vehicle.bodies.begin(), vehicle.bodies.end(), [](const Body& body) {
    return body.motion.empty() || moves(body, Motion::kZ) || moves(body, Motion::kPitch);
  });
  if (!vehicle.bodies.empty() && !any) {
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
    Judge judge(problems, pathOf("element"), element.name, element.origin);
    judge.notNegative("stiffness_z", element.stiffness_z, kStiffness);
    judge.notNegative("damping_z", element.damping_z, kDamping);
  }
  for (const Group& group : vehicle.groups) {
    Judge(problems, pathOf("group"), group.name, group.origin).finite("x", group.x, kLength);
  }
  for (const Body& body : vehicle.bodies) checkBody(body, problems);
  for (const Wheelset& wheelset : vehicle.wheelsets) checkWheelset(wheelset, problems);
  for (const Suspension& suspension : vehicle.suspensions) checkSuspension(suspension, problems);
  for (const Point& point : vehicle.points) {
    Judge(problems, pathOf("point", point.group), point.name, point.origin).finite("x", point.x, kLength);
  }
  checkHeights(vehicle, problems);
  problems.append(checkTies(vehicle));
  problems.sortByPlace();
  return problems;
}

}  // namespace vehicle
