#include "libvehicle/model/topology_part.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// What holds together: each body and wheelset knows the first of its lot.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    const std::size_t first = std::min(of(a), of(b));
    parent_[of(a)] = parent_[of(b)] = first;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

std::vector<TopologyPart> partsOf(const Topology& topology, const std::vector<char>& cut) {
  const std::size_t bodies = topology.bodies.size();
  DisjointSets lots(bodies + topology.wheelsets.size());
  const auto lowerOf = [&](const TopologySuspension& each) {
    return each.lower_body >= 0 ? at(each.lower_body) : bodies + at(each.lower_wheelset);
  };
  for (std::size_t s = 0; s < cut.size(); ++s) {
    const TopologySuspension& each = topology.suspensions[s];
    if (cut[s] == 0) lots.join(at(each.upper), lowerOf(each));
  }
  std::vector<TopologyPart> parts;
  std::map<std::size_t, std::size_t> part_of_lot;
  std::vector<int> inner(bodies + topology.wheelsets.size());  // index in its part
  const auto partOf = [&](std::size_t member) -> TopologyPart& {
    const auto [found, fresh] = part_of_lot.try_emplace(lots.of(member), parts.size());
    if (fresh) {
      Topology& made = parts.emplace_back().topology;
      made.name = topology.name;
      made.origin = topology.origin;
      made.has_heights = topology.has_heights;
    }
    return parts[found->second];
  };
  const auto count = [](int& index, Topology& in) {
    if (index >= 0) index = in.coordinates++;
  };
  for (std::size_t b = 0; b < bodies; ++b) {
    TopologyPart& part = partOf(b);
    inner[b] = static_cast<int>(part.bodies.size());
    part.bodies.push_back(static_cast<int>(b));
    TopologyBody body = topology.bodies[b];
    count(body.z_index, part.topology);
    count(body.pitch_index, part.topology);
    part.topology.bodies.push_back(std::move(body));
  }
  for (std::size_t j = 0; j < topology.wheelsets.size(); ++j) {
    TopologyPart& part = partOf(bodies + j);
    inner[bodies + j] = static_cast<int>(part.wheelsets.size());
    part.wheelsets.push_back(static_cast<int>(j));
    TopologyWheelset wheelset = topology.wheelsets[j];
    count(wheelset.z_index, part.topology);
    part.topology.wheelsets.push_back(std::move(wheelset));
  }
  for (std::size_t s = 0; s < cut.size(); ++s) {
    if (cut[s] != 0) continue;
    TopologySuspension suspension = topology.suspensions[s];
    TopologyPart& part = partOf(at(suspension.upper));
    part.suspensions.push_back(static_cast<int>(s));
    const int lower = inner[lowerOf(suspension)];
    suspension.upper = inner[at(suspension.upper)];
    (suspension.lower_body >= 0 ? suspension.lower_body : suspension.lower_wheelset) = lower;
    part.topology.suspensions.push_back(std::move(suspension));
  }
  return parts;
}

}  // namespace vehicle
