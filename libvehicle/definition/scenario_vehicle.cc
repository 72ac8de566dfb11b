#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libvehicle/definition/judge.h"
#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/vehicle.h"

// A scenario held against the vehicle that is to run it.
namespace vehicle {

namespace {

using enum Dimension;

template <class Part>
const Part* find(const std::vector<Part>& parts, const std::string& name) {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const Part& part) { return part.name == name; });
  return found == parts.end() ? nullptr : &*found;
}

template <class Part>
void append(std::vector<std::string>& names, const std::vector<Part>& parts) {
  for (const Part& part : parts) names.push_back(part.name);
}

std::string orNearest(std::string wanted, const std::string& name, const std::vector<std::string>& candidates) {
  const auto nearest = nearestName(name, candidates);
  return nearest ? wanted + "; did you mean \"" + *nearest + "\"?" : wanted;
}

void checkInputs(const Rig& rig, const Vehicle& vehicle, ProblemList& problems) {
  std::vector<std::string> wheelsets;
  append(wheelsets, vehicle.wheelsets);
  for (const RigInput& input : rig.inputs) {
    if (find(vehicle.wheelsets, input.wheelset) != nullptr || !input.origin.knows("wheelset")) continue;
    Judge(problems, "<scenario><rig><input>", "", input.origin)
        .say(written("wheelset", input.wheelset) + " names no wheelset of the vehicle \"" + vehicle.name + '"',
             orNearest("a rig drives wheelsets", input.wheelset, wheelsets));
  }
}

/// A value for a motion that the part does not have would be lost without a word. 0 says nothing and is free.
void checkStill(Judge& judge, std::string_view attribute, double value, Dimension dimension, bool moving,
                const std::string& name, std::string_view motion) {
  if (moving || value == 0.0 || !judge.knows({attribute})) return;
  judge.say(judge.written(attribute, value, dimension) + ", but \"" + name + "\" has no motion " + std::string(motion),
            "leave it out");
}

void checkInitialBody(const InitialBody& initial, const Vehicle& vehicle, const std::vector<std::string>& names,
                      ProblemList& problems) {
  if (!initial.origin.knows("name")) return;
  Judge judge(problems, "<scenario><initial_state><body>", initial.name, initial.origin);
  const Body* body = find(vehicle.bodies, initial.name);
  const Wheelset* wheelset = find(vehicle.wheelsets, initial.name);
  if (body == nullptr && wheelset == nullptr) {
    judge.say(written("name", initial.name) + " names no body or wheelset of the vehicle \"" + vehicle.name + '"',
              orNearest("bodies and wheelsets have an initial state", initial.name, names));
    return;
  }
  if (wheelset != nullptr && !hasOwnMotion(*wheelset) && wheelset->origin.knowsAll()) {
    judge.say(written("name", initial.name) + " is a wheelset that follows the rail",
              "only one with mass and contact has a state of its own");
    return;
  }
  // What moves in a part that could not be read is open.
  if (!(wheelset != nullptr ? wheelset->origin : body->origin).knowsAll()) return;
  const bool rises = wheelset != nullptr || moves(*body, Motion::kZ);
  const bool pitches = wheelset == nullptr && moves(*body, Motion::kPitch);
  checkStill(judge, "z", initial.z, kLength, rises, initial.name, "z");
  checkStill(judge, "z_rate", initial.z_rate, kSpeed, rises, initial.name, "z");
  checkStill(judge, "pitch", initial.pitch, kAngle, pitches, initial.name, "pitch");
  checkStill(judge, "pitch_rate", initial.pitch_rate, kAngularVelocity, pitches, initial.name, "pitch");
}

}  // namespace

ProblemList check(const Scenario& scenario, const Vehicle& vehicle) {
  ProblemList problems;
  const auto named = [](const auto& part) { return part.origin.knows("name"); };
  if (vehicle.origin.hasStrange() || !std::all_of(vehicle.bodies.begin(), vehicle.bodies.end(), named) ||
      !std::all_of(vehicle.wheelsets.begin(), vehicle.wheelsets.end(), named)) {
    return problems;  // a name that the vehicle seems to lack may be one that could not be read
  }
  if (scenario.rig) checkInputs(*scenario.rig, vehicle, problems);
  std::vector<std::string> names;
  append(names, vehicle.bodies);
  append(names, vehicle.wheelsets);
  for (const InitialBody& initial : scenario.initial_state.bodies) {
    checkInitialBody(initial, vehicle, names, problems);
  }
  problems.sortByPlace();
  return problems;
}

void requireRight(const Vehicle& vehicle, const Scenario& scenario) {
  ProblemList problems = check(vehicle);
  problems.append(check(scenario));
  if (problems.empty()) problems.append(check(scenario, vehicle));
  if (!problems.empty()) throw InvalidInput(std::move(problems));
}

}  // namespace vehicle
