#include "libvehicle/flat/flat_statics.h"

#include <cmath>
#include <cstddef>

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

std::optional<FlatLoads> leverRule(const Topology& topology, const FlatLayout& layout, double gravity) {
  const TopologyBody& carbody = topology.bodies[at(layout.carbody)];
  const auto& suspensions = topology.suspensions;
  const double lf = suspensions[at(layout.secondary[0])].arm_upper;
  const double lr = -suspensions[at(layout.secondary[1])].arm_upper;
  // The carbody's centre of gravity lies between the pivots.
  bool applies = lf > 0.0 && lr > 0.0 && gravity >= 0.0 && std::isfinite(gravity);
  for (const TopologySuspension& suspension : suspensions) {
    applies = applies && suspension.stiffness > 0.0 && !suspension.preload;
  }
  if (!applies) return std::nullopt;
  FlatLoads loads;
  const double weight = carbody.mass * gravity;
  loads.secondary = {weight * lr / (lf + lr), weight * lf / (lf + lr)};
  for (std::size_t wheel = 0; wheel < 4; ++wheel) {
    const std::size_t bogie = wheel / 2;
    const double c = suspensions[at(layout.primary[wheel])].stiffness;
    const double c_both =
        suspensions[at(layout.primary[2 * bogie])].stiffness + suspensions[at(layout.primary[2 * bogie + 1])].stiffness;
    const TopologyWheelset& wheelset = topology.wheelsets[at(layout.wheelset[wheel])];
    loads.primary[wheel] =
        (topology.bodies[at(layout.bogie[bogie])].mass * gravity + loads.secondary[bogie]) * c / c_both;
    loads.wheel[wheel] = wheelset.load.value_or(wheelset.mass * gravity + loads.primary[wheel]);
  }
  return loads;
}

FlatLoads loadsAtRest(const Rest& rest, const FlatLayout& layout) {
  FlatLoads loads;
  for (std::size_t i = 0; i < 2; ++i) loads.secondary[i] = rest.suspension_load[at(layout.secondary[i])];
  for (std::size_t wheel = 0; wheel < 4; ++wheel) {
    loads.primary[wheel] = rest.suspension_load[at(layout.primary[wheel])];
    loads.wheel[wheel] = rest.wheel_load[at(layout.wheelset[wheel])];
  }
  return loads;
}

FlatLoads flatLoads(const CompiledModel& model, const FlatLayout& layout) {
  const std::optional<FlatLoads> loads = leverRule(model.topology, layout, model.gravity);
  return loads ? *loads : loadsAtRest(model.rest, layout);
}

FlatLoads flatLoads(const Topology& topology, const FlatLayout& layout, double gravity) {
  const std::optional<FlatLoads> loads = leverRule(topology, layout, gravity);
  return loads ? *loads : loadsAtRest(restOf(topology, gravity), layout);
}

FlatParameters flatParameters(const Topology& topology, const FlatLayout& layout, const FlatLoads& loads) {
  const TopologyBody& carbody = topology.bodies[at(layout.carbody)];
  const TopologySuspension& front = topology.suspensions[at(layout.secondary[0])];
  const TopologySuspension& rear = topology.suspensions[at(layout.secondary[1])];
  FlatParameters v;
  v.mk = carbody.mass;
  v.Jk = carbody.pitch_inertia;
  v.m1 = topology.bodies[at(layout.bogie[0])].mass;
  v.m2 = topology.bodies[at(layout.bogie[1])].mass;
  v.lf = front.arm_upper;
  v.lr = -rear.arm_upper;
  v.cs1 = front.stiffness;
  v.bs1 = front.damping;
  v.cs2 = rear.stiffness;
  v.bs2 = rear.damping;
  for (std::size_t wheel = 0; wheel < 4; ++wheel) {
    v.cp[wheel] = topology.suspensions[at(layout.primary[wheel])].stiffness;
    v.bp[wheel] = topology.suspensions[at(layout.primary[wheel])].damping;
  }
  v.k_g = loads.secondary[0] * front.height_upper + loads.secondary[1] * rear.height_upper;
  return v;
}

}  // namespace vehicle
