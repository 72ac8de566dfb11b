#include "libvehicle/model/laws.h"

#include <memory>

#include "libvehicle/law/linear_spring_damper.h"

namespace vehicle {

SuspensionLawPtr lawOf(const TopologySuspension& suspension) {
  return std::make_shared<const LinearSpringDamper>(suspension.stiffness, suspension.damping);
}

std::vector<SuspensionLawPtr> lawsOf(const Topology& topology) {
  std::vector<SuspensionLawPtr> laws;
  for (const TopologySuspension& each : topology.suspensions) laws.push_back(lawOf(each));
  return laws;
}

}  // namespace vehicle
