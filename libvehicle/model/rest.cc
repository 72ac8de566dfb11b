#include "libvehicle/model/rest.h"

#include <cmath>
#include <cstddef>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "libvehicle/model/laws.h"
#include "libvehicle/model/rest_problems.h"
#include "libvehicle/model/topology_part.h"
#include "libvehicle/statics/rest_balance.h"

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

std::string number(double value) {
  std::ostringstream text;
  text.precision(6);
  text << value;
  return text.str();
}

/// Elongation of a suspension = row . q.
Eigen::VectorXd elongationRow(const Topology& topology, const TopologySuspension& suspension) {
  Eigen::VectorXd row = Eigen::VectorXd::Zero(topology.coordinates);
  const auto add = [&row](const TopologyBody& body, double sign, double arm) {
    if (body.z_index >= 0) row[body.z_index] += sign;
    if (body.pitch_index >= 0) row[body.pitch_index] += sign * arm;
  };
  add(topology.bodies[at(suspension.upper)], 1.0, suspension.arm_upper);
  if (suspension.lower_body >= 0) {
    add(topology.bodies[at(suspension.lower_body)], -1.0, suspension.arm_lower);
  } else if (const int z = topology.wheelsets[at(suspension.lower_wheelset)].z_index; z >= 0) {
    row[z] -= 1.0;
  }
  return row;
}

RestBalance balanceOf(const Topology& topology, double gravity) {
  RestBalance balance;
  balance.weight = Eigen::VectorXd::Zero(topology.coordinates);
  for (const TopologyBody& body : topology.bodies) {
    balance.total += body.mass * gravity;
    if (body.z_index >= 0) balance.weight[body.z_index] = body.mass * gravity;
  }
  for (const TopologyWheelset& wheelset : topology.wheelsets) {
    RestContact& contact = balance.contacts.emplace_back();
    contact.coordinate = wheelset.z_index;
    contact.weight = wheelset.mass * gravity;
    contact.stiffness = wheelset.contact_stiffness;
    contact.hertz_constant = wheelset.hertz_constant.value_or(0.0);
    if (wheelset.z_index >= 0) balance.weight[wheelset.z_index] = contact.weight;
  }
  for (std::size_t s = 0; s < topology.suspensions.size(); ++s) {
    const TopologySuspension& each = topology.suspensions[s];
    balance.springs.push_back({elongationRow(topology, each), lawOf(each), each.preload});
    if (each.lower_wheelset >= 0) balance.contacts[at(each.lower_wheelset)].above.push_back(s);
  }
  return balance;
}

std::vector<double> pitchStiffness(const Topology& topology, const std::vector<double>& suspension_load) {
  std::vector<double> stiffness(topology.bodies.size(), 0.0);
  for (std::size_t s = 0; s < suspension_load.size(); ++s) {
    const TopologySuspension& suspension = topology.suspensions[s];
    stiffness[at(suspension.upper)] += suspension_load[s] * suspension.height_upper;
    if (suspension.lower_body >= 0) {
      stiffness[at(suspension.lower_body)] -= suspension_load[s] * suspension.height_lower;
    }
  }
  return stiffness;
}

/// The rest position of what hangs together.
Rest restOfPart(const Topology& topology, double gravity) {
  const RestBalance balance = balanceOf(topology, gravity);
  const RestSolution solved = solveRest(balance);
  ProblemList problems = uncarried(topology, gravity, balance, solved);
  if (!problems.empty()) throw InvalidInput(std::move(problems));

  Rest rest;
  rest.coordinates.assign(solved.deflection.begin(), solved.deflection.end());
  rest.suspension_load = solved.spring_load;
  rest.wheel_load = solved.contact_load;
  for (std::size_t j = 0; j < rest.wheel_load.size(); ++j) {
    if (topology.wheelsets[j].load) rest.wheel_load[j] = *topology.wheelsets[j].load;
  }
  problems = wheelsOffTheRail(topology, rest.wheel_load);
  if (!problems.empty()) throw InvalidInput(std::move(problems));

  rest.pitch_stiffness = pitchStiffness(topology, rest.suspension_load);
  rest.contact_stiffness.assign(rest.wheel_load.size(), 0.0);
  for (std::size_t j = 0; j < rest.wheel_load.size(); ++j) {
    const TopologyWheelset& wheelset = topology.wheelsets[j];
    if (wheelset.z_index < 0) continue;
    rest.contact_stiffness[j] =
        wheelset.contact_stiffness
            ? *wheelset.contact_stiffness
            : 1.5 * std::cbrt(std::pow(wheelset.hertz_constant.value_or(0.0), 2.0) * rest.wheel_load[j]);
  }
  return rest;
}

/// Puts what a part says where it belongs in the whole.
void put(const TopologyPart& part, const Topology& whole, const Rest& from, Rest& to) {
  const auto move = [&](int here, int there) {
    if (here >= 0) to.coordinates[at(there)] = from.coordinates[at(here)];
  };
  for (std::size_t b = 0; b < part.bodies.size(); ++b) {
    const TopologyBody& body = whole.bodies[at(part.bodies[b])];
    move(part.topology.bodies[b].z_index, body.z_index);
    move(part.topology.bodies[b].pitch_index, body.pitch_index);
    to.pitch_stiffness[at(part.bodies[b])] = from.pitch_stiffness[b];
  }
  for (std::size_t j = 0; j < part.wheelsets.size(); ++j) {
    move(part.topology.wheelsets[j].z_index, whole.wheelsets[at(part.wheelsets[j])].z_index);
    to.wheel_load[at(part.wheelsets[j])] = from.wheel_load[j];
    to.contact_stiffness[at(part.wheelsets[j])] = from.contact_stiffness[j];
  }
  for (std::size_t s = 0; s < part.suspensions.size(); ++s) {
    to.suspension_load[at(part.suspensions[s])] = from.suspension_load[s];
  }
}

}  // namespace

Rest restOf(const Topology& topology, double gravity) {
  if (!(gravity >= 0.0 && std::isfinite(gravity))) {
    throw std::invalid_argument("restOf: gravity = " + number(gravity) + ", must be finite and >= 0");
  }
  // A suspension that is given no load takes no part in the balance: the vehicles of a train rest each for itself, and
  // the work grows with their number instead of its cube.
  std::vector<char> cut;
  for (const TopologySuspension& each : topology.suspensions) cut.push_back(each.preload == 0.0 ? 1 : 0);
  const std::vector<TopologyPart> parts = partsOf(topology, cut);
  if (parts.size() == 1) return restOfPart(topology, gravity);
  Rest rest;
  rest.coordinates.assign(at(topology.coordinates), 0.0);
  rest.suspension_load.assign(topology.suspensions.size(), 0.0);
  rest.wheel_load.assign(topology.wheelsets.size(), 0.0);
  rest.pitch_stiffness.assign(topology.bodies.size(), 0.0);
  rest.contact_stiffness.assign(topology.wheelsets.size(), 0.0);
  ProblemList problems;
  // Equal vehicles of a train come from one place of one file: their mistake is reported once.
  std::set<std::tuple<std::string, int, std::string>> seen;
  for (const TopologyPart& part : parts) {
    try {
      put(part, topology, restOfPart(part.topology, gravity), rest);
    } catch (const InvalidInput& wrong) {
      for (const Problem& each : wrong.problems()) {
        const Place& place = each.place;
        if (place.line > 0 && !seen.emplace(place.file, place.line, each.message).second) continue;
        problems.add(each);
      }
    }
  }
  if (!problems.empty()) throw InvalidInput(std::move(problems));
  return rest;
}

}  // namespace vehicle
