#include "libvehicle/flat/flat_train_layout.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Bodies that stand on other bodies and on no wheelset.
std::vector<char> carbodiesOf(const Topology& topology) {
  std::vector<char> on_bodies(topology.bodies.size(), 0);
  std::vector<char> on_wheels(topology.bodies.size(), 0);
  for (const TopologySuspension& each : topology.suspensions) {
    if (each.lower_body < 0) on_wheels[at(each.upper)] = 1;
  }
  for (const TopologySuspension& each : topology.suspensions) {
    if (each.lower_body >= 0 && on_wheels[at(each.lower_body)] != 0) on_bodies[at(each.upper)] = 1;
  }
  for (std::size_t b = 0; b < on_bodies.size(); ++b) on_bodies[b] = on_bodies[b] != 0 && on_wheels[b] == 0 ? 1 : 0;
  return on_bodies;
}

std::vector<char> couplingsOf(const Topology& topology) {
  const std::vector<char> carbodies = carbodiesOf(topology);
  std::vector<char> couplings;
  for (const TopologySuspension& each : topology.suspensions) {
    const bool joins = each.lower_body >= 0 && carbodies[at(each.upper)] != 0 && carbodies[at(each.lower_body)] != 0;
    couplings.push_back(joins ? 1 : 0);
  }
  return couplings;
}

FlatLayout inWhole(FlatLayout layout, const TopologyPart& part) {
  layout.carbody = part.bodies[at(layout.carbody)];
  for (int& each : layout.bogie) each = part.bodies[at(each)];
  for (int& each : layout.secondary) each = part.suspensions[at(each)];
  for (int& each : layout.primary) each = part.suspensions[at(each)];
  for (int& each : layout.wheelset) each = part.wheelsets[at(each)];
  return layout;
}

void readCouplings(const Topology& topology, FlatTrainReading& reading) {
  FlatTrainLayout& layout = reading.layout;
  std::map<int, std::size_t> place_of;  // of each carbody along the train
  for (std::size_t v = 0; v < layout.vehicles.size(); ++v) place_of.emplace(layout.vehicles[v].layout.carbody, v);
  layout.couplings.assign(layout.vehicles.empty() ? 0 : layout.vehicles.size() - 1, -1);
  const std::vector<char> couplings = couplingsOf(topology);
  for (std::size_t s = 0; s < couplings.size(); ++s) {
    if (couplings[s] == 0) continue;
    const TopologySuspension& coupling = topology.suspensions[s];
    const auto unsupported = [&](std::string message) {
      reading.problems.add({coupling.origin, fmt::format("<suspension name=\"{}\">", coupling.name), std::move(message),
                            "take the form matrix, which computes any train"});
    };
    const auto [ahead, behind] = std::minmax(place_of.at(coupling.upper), place_of.at(coupling.lower_body));
    if (behind != ahead + 1) {
      unsupported(fmt::format(
          "joins \"{}\" to \"{}\", which do not follow each other; the form flat computes couplings between "
          "neighbours",
          topology.bodies[at(coupling.upper)].name, topology.bodies[at(coupling.lower_body)].name));
    } else if (layout.couplings[ahead] >= 0) {
      unsupported(
          fmt::format("stands beside \"{}\" between the same vehicles; the form flat computes one coupling there",
                      topology.suspensions[at(layout.couplings[ahead])].name));
    } else {
      layout.couplings[ahead] = static_cast<int>(s);
    }
  }
}

}  // namespace

bool isTrain(const Topology& topology) {
  if (topology.units > 1) return true;
  const std::vector<char> couplings = couplingsOf(topology);
  return std::find(couplings.begin(), couplings.end(), 1) != couplings.end();
}

FlatTrainReading readTrainLayout(const Topology& topology) {
  FlatTrainReading reading;
  std::set<std::pair<std::string, int>> told;
  for (TopologyPart& part : partsOf(topology, couplingsOf(topology))) {
    const FlatReading read = readLayout(part.topology);
    if (read.problems.empty()) {
      reading.layout.vehicles.push_back({inWhole(read.layout, part), std::move(part.topology), read.layout});
      continue;
    }
    const Place& first = read.problems[0].place;
    if (first.line == 0 || told.emplace(first.file, first.line).second) reading.problems.append(read.problems);
  }
  if (!reading.problems.empty()) return reading;
  std::stable_sort(reading.layout.vehicles.begin(), reading.layout.vehicles.end(),
                   [&](const FlatTrainVehicle& a, const FlatTrainVehicle& b) {
                     return topology.bodies[at(a.layout.carbody)].x > topology.bodies[at(b.layout.carbody)].x;
                   });
  readCouplings(topology, reading);
  return reading;
}

}  // namespace vehicle
