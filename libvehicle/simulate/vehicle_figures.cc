#include "libvehicle/simulate/vehicle_figures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>

#include "libvehicle/definition/train.h"
#include "libvehicle/linear/modes.h"
#include "libvehicle/simulate/forms.h"

namespace vehicle {
namespace {

constexpr double kEqual = 5e-4;  // loads that differ by less show as equal in three digits

std::string_view unitOf(const std::string& part) { return std::string_view(part).substr(0, part.find('.')); }

/// The mode in which that coordinate takes most part.
const Mode* modeOf(const std::vector<Mode>& modes, int coordinate) {
  const auto part = [&](const Mode& mode) { return mode.participation(coordinate); };
  const auto found =
      std::max_element(modes.begin(), modes.end(), [&](const Mode& a, const Mode& b) { return part(a) < part(b); });
  return found == modes.end() ? nullptr : &*found;
}

/// Nothing where they are alike in three digits.
std::optional<HalfLoads> halvesOf(const Topology& topology, const Rest& rest) {
  const auto [last, first] =
      std::minmax_element(topology.wheelsets.begin(), topology.wheelsets.end(),
                          [](const TopologyWheelset& a, const TopologyWheelset& b) { return a.x < b.x; });
  const double middle = 0.5 * (first->x + last->x);
  HalfLoads halves;
  for (std::size_t j = 0; j < topology.wheelsets.size(); ++j) {
    const double x = topology.wheelsets[j].x;
    halves.front += x > middle ? rest.wheel_load[j] : x == middle ? 0.5 * rest.wheel_load[j] : 0.0;
    halves.rear += x < middle ? rest.wheel_load[j] : x == middle ? 0.5 * rest.wheel_load[j] : 0.0;
  }
  if (std::abs(halves.front - halves.rear) > kEqual * (halves.front + halves.rear)) return halves;
  return std::nullopt;
}

std::vector<CarbodyMotion> carbodyMotions(const CompiledModel& model) {
  const Topology& topology = model.topology;
  std::vector<CarbodyMotion> motions;
  const int top = topology.units == 0 ? carbodyOf(model.vehicle) : -1;
  if (top < 0) return motions;
  const TopologyBody& body = topology.bodies[static_cast<std::size_t>(top)];
  const std::vector<Mode> modes = modesOf(*buildForm(defaultForm(topology), model));
  const auto add = [&](const char* motion, int coordinate) {
    if (coordinate < 0) return;
    if (const Mode* mode = modeOf(modes, coordinate)) {
      motions.push_back({body.name + ' ' + motion, mode->frequency, mode->damping_ratio});
    }
  };
  add("bounce", body.z_index);
  add("pitch", body.pitch_index);
  return motions;
}

}  // namespace

VehicleFigures figuresOf(const CompiledModel& model) {
  VehicleFigures figures;
  const Topology& topology = model.topology;
  double bodies = 0.0;
  for (const TopologyBody& body : topology.bodies) bodies += body.mass;
  double all = bodies;
  for (const TopologyWheelset& wheelset : topology.wheelsets) {
    figures.unsprung_mass += wheelset.mass;
    all += wheelset.mass;
  }
  figures.mass = bodies + figures.unsprung_mass;
  figures.weight = all * model.gravity;
  if (topology.units == 0) figures.halves = halvesOf(topology, model.rest);
  figures.load_deviations = loadDeviations(topology, model.rest);
  figures.carbody = carbodyMotions(model);
  return figures;
}

std::vector<double> loadDeviations(const Topology& topology, const Rest& rest) {
  struct Mean {
    double sum = 0.0;
    double count = 0.0;
  };
  std::map<std::string_view, Mean> means;
  const auto keyOf = [&](std::size_t j) {
    return topology.units > 0 ? unitOf(topology.wheelsets[j].name) : std::string_view();
  };
  for (std::size_t j = 0; j < topology.wheelsets.size(); ++j) {
    Mean& mean = means[keyOf(j)];
    mean.sum += rest.wheel_load[j];
    ++mean.count;
  }
  std::vector<double> deviations;
  double largest = 0.0;
  for (std::size_t j = 0; j < topology.wheelsets.size(); ++j) {
    const Mean& mean = means[keyOf(j)];
    deviations.push_back(mean.sum > 0.0 ? rest.wheel_load[j] * mean.count / mean.sum - 1.0 : 0.0);
    largest = std::max(largest, std::abs(deviations.back()));
  }
  if (largest <= kEqual) deviations.clear();
  return deviations;
}

}  // namespace vehicle
