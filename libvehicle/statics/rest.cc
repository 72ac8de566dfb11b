#include "libvehicle/statics/rest.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include <Eigen/QR>

#include "libvehicle/definition/topology_part.h"
#include "libvehicle/statics/rest_problems.h"

namespace vehicle {
namespace {

// Contact springs are about 1000 times stiffer than suspensions, and the scaled matrix takes that out; below
// this share of its largest pivot a direction has no spring at all.
constexpr double kRank = 1e-12;
constexpr int kHertzIterations = 100;

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

/// K d = force
struct Balance {
  Eigen::MatrixXd stiffness;
  Eigen::VectorXd force;
};

Balance suspensionBalance(const Topology& topology, double gravity, const std::vector<Eigen::VectorXd>& rows) {
  const int n = topology.coordinates;
  Balance balance{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)};
  for (const TopologyBody& body : topology.bodies) {
    if (body.z_index >= 0) balance.force[body.z_index] -= body.mass * gravity;
  }
  for (const TopologyWheelset& wheelset : topology.wheelsets) {
    if (wheelset.z_index >= 0) balance.force[wheelset.z_index] -= wheelset.mass * gravity;
  }
  for (std::size_t s = 0; s < rows.size(); ++s) {
    const TopologySuspension& suspension = topology.suspensions[s];
    if (suspension.preload) {
      balance.force += *suspension.preload * rows[s];
    } else {
      balance.stiffness += suspension.stiffness * rows[s] * rows[s].transpose();
    }
  }
  return balance;
}

/// Least deflections that satisfy the balance; motions without any spring stay at 0.
Eigen::VectorXd solve(const Balance& balance) {
  const Eigen::Index n = balance.force.size();
  if (n == 0) return {};
  Eigen::VectorXd scale(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double k = balance.stiffness(i, i);
    scale[i] = k > 0.0 ? 1.0 / std::sqrt(k) : 1.0;
  }
  const Eigen::MatrixXd scaled = scale.asDiagonal() * balance.stiffness * scale.asDiagonal();
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(kRank);
  decomposition.compute(scaled);
  const Eigen::VectorXd right = scale.asDiagonal() * balance.force;
  Eigen::VectorXd solution = decomposition.solve(right);
  // One refinement brings the loads to rounding level, so that mirrored axles show equal loads to the last digits.
  solution += decomposition.solve(Eigen::VectorXd(right - scaled * solution));
  return scale.asDiagonal() * solution;
}

/// Wheel-rail forces by vertical equilibrium of each wheelset.
std::vector<double> railForces(const Topology& topology, double gravity, const std::vector<double>& suspension_load) {
  std::vector<double> force(topology.wheelsets.size());
  for (std::size_t j = 0; j < force.size(); ++j) force[j] = topology.wheelsets[j].mass * gravity;
  for (std::size_t s = 0; s < suspension_load.size(); ++s) {
    const int wheelset = topology.suspensions[s].lower_wheelset;
    if (wheelset >= 0) force[at(wheelset)] += suspension_load[s];
  }
  return force;
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

double largestChange(const std::vector<double>& now, const std::vector<double>& before) {
  double change = 0.0;
  for (std::size_t j = 0; j < now.size(); ++j) change = std::max(change, std::abs(now[j] - before[j]));
  return change;
}

/// The rest position of what hangs together.
Rest restOfPart(const Topology& topology, double gravity) {
  std::vector<Eigen::VectorXd> rows;
  rows.reserve(topology.suspensions.size());
  double weight = 0.0;
  for (const TopologySuspension& suspension : topology.suspensions) rows.push_back(elongationRow(topology, suspension));
  for (const TopologyBody& body : topology.bodies) weight += body.mass * gravity;
  const Balance on_springs = suspensionBalance(topology, gravity, rows);

  // A Hertz spring is as stiff as its load makes it, F / delta = C^(2/3) F^(1/3), and where axles share a load
  // the load depends on that stiffness. Contacts are far stiffer than suspensions, so the loop contracts fast.
  Rest rest;
  std::vector<double> force(topology.wheelsets.size(),
                            weight / std::max(1.0, static_cast<double>(topology.wheelsets.size())));
  Balance balance = on_springs;
  Eigen::VectorXd deflection;
  for (int iteration = 0; iteration < kHertzIterations; ++iteration) {
    balance = on_springs;
    bool hertz = false;
    for (std::size_t j = 0; j < topology.wheelsets.size(); ++j) {
      const TopologyWheelset& wheelset = topology.wheelsets[j];
      if (wheelset.z_index < 0) continue;
      if (!wheelset.contact_stiffness) hertz = true;
      balance.stiffness(wheelset.z_index, wheelset.z_index) +=
          wheelset.contact_stiffness
              ? *wheelset.contact_stiffness
              : std::cbrt(std::pow(wheelset.hertz_constant.value_or(0.0), 2.0) * std::max(force[j], 1e-9 * weight));
    }
    deflection = solve(balance);
    rest.suspension_load.assign(rows.size(), 0.0);
    for (std::size_t s = 0; s < rows.size(); ++s) {
      const TopologySuspension& suspension = topology.suspensions[s];
      rest.suspension_load[s] =
          suspension.preload ? *suspension.preload : 0.0 - suspension.stiffness * rows[s].dot(deflection);
    }
    const std::vector<double> before = std::exchange(force, railForces(topology, gravity, rest.suspension_load));
    if (!hertz || largestChange(force, before) <= 1e-15 * weight) break;
  }

  ProblemList problems =
      uncarried(topology, gravity, {rows, rest.suspension_load, on_springs.force, balance.force - balance.stiffness * deflection});
  if (!problems.empty()) throw InvalidInput(std::move(problems));

  rest.coordinates.assign(deflection.begin(), deflection.end());
  rest.wheel_load = force;
  for (std::size_t j = 0; j < force.size(); ++j) {
    if (topology.wheelsets[j].load) rest.wheel_load[j] = *topology.wheelsets[j].load;
  }
  problems = wheelsOffTheRail(topology, rest.wheel_load);
  if (!problems.empty()) throw InvalidInput(std::move(problems));

  rest.pitch_stiffness = pitchStiffness(topology, rest.suspension_load);
  rest.contact_stiffness.assign(force.size(), 0.0);
  for (std::size_t j = 0; j < force.size(); ++j) {
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
