#include "libvehicle/definition/train_part.h"

namespace vehicle {

bool isRead(const TrainVehicle& each) { return !each.vehicle.bodies.empty(); }

const std::string& unitName(const TrainVehicle& each) { return each.name.empty() ? each.vehicle.name : each.name; }

std::string quotedName(const TrainVehicle& each) {
  return '"' + (each.file.empty() ? unitName(each) : each.file) + '"';
}

double bodyX(const Vehicle& vehicle, const Body& body) {
  for (const Group& group : vehicle.groups) {
    if (!body.group.empty() && group.name == body.group) return group.x + body.x;
  }
  return body.x;
}

const Coupling* couplingAt(const Train& train, std::size_t gap) {
  if (train.couplings.empty()) return nullptr;
  return &train.couplings[train.couplings.size() == 1 ? 0 : gap];
}

double shiftBetween(const TrainVehicle& ahead, const TrainVehicle& behind) {
  return 0.5 * (ahead.spacing + behind.spacing);
}

}  // namespace vehicle
