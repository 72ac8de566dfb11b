#include "libvehicle/matrix/assembly.h"

#include <algorithm>

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

void addTerm(Elongation& elongation, int q, double arm) {
  if (q < 0 || arm == 0.0) return;
  elongation.terms[at(elongation.count)] = {q, arm};
  ++elongation.count;
}

SecondOrderEntry& entryAt(std::vector<SecondOrderEntry>& row, int column) {
  const auto found = std::lower_bound(row.begin(), row.end(), column,
                                      [](const SecondOrderEntry& each, int wanted) { return each.column < wanted; });
  if (found != row.end() && found->column == column) return *found;
  return *row.insert(found, {column, 0.0, 0.0});
}

}  // namespace

Elongation elongationOf(const TopologySuspension& suspension, const Topology& topology) {
  Elongation elongation;
  const TopologyBody& upper = topology.bodies[at(suspension.upper)];
  addTerm(elongation, upper.z_index, 1.0);
  addTerm(elongation, upper.pitch_index, suspension.arm_upper);
  if (suspension.lower_body >= 0) {
    const TopologyBody& lower = topology.bodies[at(suspension.lower_body)];
    addTerm(elongation, lower.z_index, -1.0);
    addTerm(elongation, lower.pitch_index, -suspension.arm_lower);
    return elongation;
  }
  const TopologyWheelset& wheelset = topology.wheelsets[at(suspension.lower_wheelset)];
  addTerm(elongation, wheelset.z_index, -1.0);
  if (wheelset.z_index < 0) elongation.channel = suspension.lower_wheelset;
  return elongation;
}

SparseSecondOrder assemble(const Topology& topology, const Rest& rest, const std::vector<SuspensionLawPtr>& laws) {
  const std::size_t n = at(topology.coordinates);
  SparseSecondOrder made{std::vector<double>(n, 0.0), std::vector<std::vector<SecondOrderEntry>>(n),
                         std::vector<std::vector<SecondOrderEntry>>(n)};
  for (std::size_t b = 0; b < topology.bodies.size(); ++b) {
    const TopologyBody& body = topology.bodies[b];
    if (body.z_index >= 0) made.mass[at(body.z_index)] = body.mass;
    if (body.pitch_index < 0) continue;
    made.mass[at(body.pitch_index)] = body.pitch_inertia;
    entryAt(made.own[at(body.pitch_index)], body.pitch_index).stiffness += rest.pitch_stiffness[b];
  }
  for (std::size_t s = 0; s < topology.suspensions.size(); ++s) {
    const Elongation elongation = elongationOf(topology.suspensions[s], topology);
    const LawSlopes slopes = laws[s]->slopes({});
    for (int i = 0; i < elongation.count; ++i) {
      const auto& [q, arm] = elongation.terms[at(i)];
      for (int j = 0; j < elongation.count; ++j) {
        // Both arms first: a factor drawn into one side would round entry (i, j) unlike entry (j, i).
        const double square = arm * elongation.terms[at(j)].arm;
        SecondOrderEntry& entry = entryAt(made.own[at(q)], elongation.terms[at(j)].q);
        entry.stiffness += slopes.elongation * square;
        entry.damping += slopes.rate * square;
      }
      if (elongation.channel < 0) continue;
      SecondOrderEntry& entry = entryAt(made.rail[at(q)], elongation.channel);
      entry.stiffness += slopes.elongation * arm;
      entry.damping += slopes.rate * arm;
    }
  }
  for (std::size_t j = 0; j < topology.wheelsets.size(); ++j) {
    const int z = topology.wheelsets[j].z_index;
    if (z < 0) continue;
    made.mass[at(z)] = topology.wheelsets[j].mass;
    for (SecondOrderEntry* entry : {&entryAt(made.own[at(z)], z), &entryAt(made.rail[at(z)], static_cast<int>(j))}) {
      entry->stiffness += rest.contact_stiffness[j];
      entry->damping += topology.wheelsets[j].contact_damping;
    }
  }
  return made;
}

SecondOrder withZeros(const SparseSecondOrder& sparse, int channels) {
  const auto n = static_cast<Eigen::Index>(sparse.mass.size());
  SecondOrder made{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n),
                   Eigen::MatrixXd::Zero(n, channels), Eigen::MatrixXd::Zero(n, channels)};
  for (Eigen::Index i = 0; i < n; ++i) {
    made.M(i, i) = sparse.mass[static_cast<std::size_t>(i)];
    for (const SecondOrderEntry& each : sparse.own[static_cast<std::size_t>(i)]) {
      made.K(i, each.column) = each.stiffness;
      made.C(i, each.column) = each.damping;
    }
    for (const SecondOrderEntry& each : sparse.rail[static_cast<std::size_t>(i)]) {
      made.B0(i, each.column) = each.stiffness;
      made.B1(i, each.column) = each.damping;
    }
  }
  return made;
}

}  // namespace vehicle
