#include "libvehicle/threads/placement.h"

#include <sched.h>

#include <algorithm>
#include <array>
#include <memory>

#include <hwloc.h>

namespace vehicle {

namespace {

// A processing unit and the physical core it belongs to.
struct Unit {
  int number = 0;
  int core = 0;
};

// What the machine is made of does not change while a program runs, and asking costs milliseconds: asked once.
const std::vector<Unit>& unitsOfTheMachine() {
  static const std::vector<Unit> units = [] {
    std::vector<Unit> found;
    hwloc_topology_t opened = nullptr;
    if (hwloc_topology_init(&opened) != 0) return found;
    const std::unique_ptr<hwloc_topology, void (*)(hwloc_topology_t)> topology(opened, hwloc_topology_destroy);
    // Only cores and units are asked for: caches, packages and devices would be read for nothing.
    hwloc_topology_set_all_types_filter(opened, HWLOC_TYPE_FILTER_KEEP_NONE);
    hwloc_topology_set_type_filter(opened, HWLOC_OBJ_CORE, HWLOC_TYPE_FILTER_KEEP_ALL);
    if (hwloc_topology_load(opened) != 0) return found;
    for (hwloc_obj_t unit = hwloc_get_next_obj_by_type(opened, HWLOC_OBJ_PU, nullptr); unit != nullptr;
         unit = hwloc_get_next_obj_by_type(opened, HWLOC_OBJ_PU, unit)) {
      const hwloc_obj_t core = hwloc_get_ancestor_obj_by_type(opened, HWLOC_OBJ_CORE, unit);
      found.push_back({static_cast<int>(unit->os_index),
                       static_cast<int>(core != nullptr ? core->logical_index : unit->logical_index)});
    }
    return found;
  }();
  return units;
}

constexpr std::size_t kMostUnits = 8 * CPU_SETSIZE;
using Mask = std::array<cpu_set_t, 8>;

// The order of the mask, which Linux numbers from 0 without gaps that matter here.
std::vector<int> maskOfThisThread() {
  Mask mask{};
  std::vector<int> allowed;
  if (sched_getaffinity(0, sizeof mask, mask.data()) != 0) return {0};
  for (std::size_t unit = 0; unit < kMostUnits; ++unit) {
    if (CPU_ISSET_S(unit, sizeof mask, mask.data())) allowed.push_back(static_cast<int>(unit));
  }
  if (allowed.empty()) allowed.push_back(0);
  return allowed;
}

// The allowed units in hwloc's order, those it was not told about at the end with a core of their own.
std::vector<Unit> allowedUnits() {
  std::vector<int> left = maskOfThisThread();
  std::vector<Unit> allowed;
  for (const Unit& unit : unitsOfTheMachine()) {
    const auto place = std::ranges::find(left, unit.number);
    if (place == left.end()) continue;
    allowed.push_back(unit);
    left.erase(place);
  }
  for (const int number : left) allowed.push_back({number, -1 - number});
  return allowed;
}

}  // namespace

std::vector<int> allowedCores() {
  std::vector<int> ordered;
  std::vector<Unit> left = allowedUnits();
  while (!left.empty()) {
    std::vector<int> taken;  // cores met in this round: one unit of each
    std::erase_if(left, [&](const Unit& unit) {
      if (std::ranges::find(taken, unit.core) != taken.end()) return false;
      taken.push_back(unit.core);
      ordered.push_back(unit.number);
      return true;
    });
  }
  return ordered;
}

int allowedCoreCount() { return static_cast<int>(maskOfThisThread().size()); }

}  // namespace vehicle
