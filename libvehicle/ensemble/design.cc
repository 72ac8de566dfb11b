#include "libvehicle/ensemble/design.h"

#include <algorithm>
#include <string>
#include <vector>

#include "libvehicle/flat/flat_statics.h"
#include "libvehicle/model/rest.h"

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// Indices of the measuring points that stand on the carbody, in file order.
std::vector<std::size_t> carbodyPoints(const Topology& topology, const FlatLayout& layout) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < topology.points.size(); ++i) {
    if (topology.points[i].body == layout.carbody) found.push_back(i);
  }
  return found;
}

// A quantity's place after the first column of its part, or nothing.
std::optional<int> placeOf(std::string_view quantity, std::initializer_list<std::string_view> quantities) {
  const auto found = std::find(quantities.begin(), quantities.end(), quantity);
  if (found == quantities.end()) return std::nullopt;
  return static_cast<int>(found - quantities.begin());
}

std::optional<FlatColumn> after(FlatColumn first, std::optional<int> place) {
  if (!place) return std::nullopt;
  return static_cast<FlatColumn>(static_cast<int>(first) + *place);
}

}  // namespace

EnsembleDesign ensembleDesign(const Topology& topology, const FlatLayout& layout, double gravity) {
  const FlatLoads loads = flatLoads(topology, layout, gravity);
  EnsembleDesign design;
  design.vehicle = flatParameters(topology, layout, loads);
  design.wheel_load = loads.wheel;
  for (std::size_t j = 0; j < 4; ++j) design.wheelset_mass[j] = topology.wheelsets[at(layout.wheelset[j])].mass;
  const std::vector<std::size_t> points = carbodyPoints(topology, layout);
  for (std::size_t i = 0; i < std::min<std::size_t>(points.size(), kMostPoints); ++i) {
    design.point_arm[i] = topology.points[points[i]].arm;
  }
  return design;
}

std::optional<FlatColumn> flatColumn(const Topology& topology, const FlatLayout& layout, std::string_view name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  const std::string_view part = name.substr(0, dot);
  const std::string_view quantity = name.substr(dot + 1);
  if (part == topology.bodies[at(layout.carbody)].name) {
    return after(FlatColumn::kCarbodyZ, placeOf(quantity, {"z", "pitch", "vz", "pitch_rate", "az", "pitch_acc"}));
  }
  const std::optional<int> vertical = placeOf(quantity, {"z", "vz", "az"});
  const FlatColumn bogie[] = {FlatColumn::kFrontBogieZ, FlatColumn::kRearBogieZ};
  const FlatColumn secondary[] = {FlatColumn::kSecondaryFrontDeflection, FlatColumn::kSecondaryRearDeflection};
  for (std::size_t i = 0; i < 2; ++i) {
    if (part == topology.bodies[at(layout.bogie[i])].name) return after(bogie[i], vertical);
    if (part == topology.suspensions[at(layout.secondary[i])].name) {
      return after(secondary[i], placeOf(quantity, {"deflection", "force"}));
    }
  }
  for (int j = 0; j < 4; ++j) {
    if (part == topology.suspensions[at(layout.primary[at(j)])].name) {
      const std::optional<int> place = placeOf(quantity, {"deflection", "force"});
      return place ? after(FlatColumn::kPrimary1Deflection, 2 * j + *place) : std::nullopt;
    }
    if (part == topology.wheelsets[at(layout.wheelset[at(j)])].name) {
      const std::optional<int> place = placeOf(quantity, {"rail_z", "load"});
      return place ? after(FlatColumn::kWheel1RailZ, 2 * j + *place) : std::nullopt;
    }
  }
  int on_carbody = 0;
  for (const TopologyPoint& point : topology.points) {
    const bool here = point.name == part;
    if (point.body == layout.carbody) {
      if (here && on_carbody < kMostPoints && vertical) {
        return pointColumn(on_carbody, static_cast<PointQuantity>(*vertical));
      }
      ++on_carbody;
    } else if (here) {
      // A bogie of the flat form does not pitch: its points move as it does.
      return after(bogie[point.body == layout.bogie[0] ? 0 : 1], vertical);
    }
  }
  return std::nullopt;
}

}  // namespace vehicle
