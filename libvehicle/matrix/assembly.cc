#include "libvehicle/matrix/assembly.h"

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

void addBody(Eigen::RowVectorXd& row, const TopologyBody& body, double sign, double arm) {
  if (body.z_index >= 0) row[body.z_index] += sign;
  if (body.pitch_index >= 0) row[body.pitch_index] += sign * arm;
}

}  // namespace

Elongation elongationOf(const TopologySuspension& suspension, const Topology& topology) {
  Elongation elongation{Eigen::RowVectorXd::Zero(topology.coordinates), -1};
  addBody(elongation.row, topology.bodies[at(suspension.upper)], 1.0, suspension.arm_upper);
  if (suspension.lower_body >= 0) {
    addBody(elongation.row, topology.bodies[at(suspension.lower_body)], -1.0, suspension.arm_lower);
    return elongation;
  }
  const TopologyWheelset& wheelset = topology.wheelsets[at(suspension.lower_wheelset)];
  if (wheelset.z_index >= 0) {
    elongation.row[wheelset.z_index] -= 1.0;
  } else {
    elongation.channel = suspension.lower_wheelset;
  }
  return elongation;
}

SecondOrder assemble(const Topology& topology, const Rest& rest) {
  const Eigen::Index n = topology.coordinates;
  const auto w = static_cast<Eigen::Index>(topology.wheelsets.size());
  SecondOrder made{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n),
                   Eigen::MatrixXd::Zero(n, w), Eigen::MatrixXd::Zero(n, w)};
  for (std::size_t b = 0; b < topology.bodies.size(); ++b) {
    const TopologyBody& body = topology.bodies[b];
    if (body.z_index >= 0) made.M(body.z_index, body.z_index) = body.mass;
    if (body.pitch_index >= 0) {
      made.M(body.pitch_index, body.pitch_index) = body.pitch_inertia;
      made.K(body.pitch_index, body.pitch_index) += rest.pitch_stiffness[b];
    }
  }
  for (const TopologySuspension& suspension : topology.suspensions) {
    const Elongation elongation = elongationOf(suspension, topology);
    // r^T r first: a factor drawn into one side would round entry (i, j) unlike entry (j, i).
    const Eigen::MatrixXd square = elongation.row.transpose() * elongation.row;
    made.K += suspension.stiffness * square;
    made.C += suspension.damping * square;
    if (elongation.channel < 0) continue;
    made.B0.col(elongation.channel) += suspension.stiffness * elongation.row.transpose();
    made.B1.col(elongation.channel) += suspension.damping * elongation.row.transpose();
  }
  for (std::size_t j = 0; j < topology.wheelsets.size(); ++j) {
    const int z = topology.wheelsets[j].z_index;
    if (z < 0) continue;
    made.M(z, z) = topology.wheelsets[j].mass;
    made.K(z, z) += rest.contact_stiffness[j];
    made.C(z, z) += topology.wheelsets[j].contact_damping;
    made.B0(z, static_cast<Eigen::Index>(j)) += rest.contact_stiffness[j];
    made.B1(z, static_cast<Eigen::Index>(j)) += topology.wheelsets[j].contact_damping;
  }
  return made;
}

}  // namespace vehicle
