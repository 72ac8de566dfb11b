#include "libvehicle/model/geometry_warnings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "libvehicle/units/quantity.h"

namespace vehicle {
namespace {

constexpr double kOnePlace = 1e-3;   // [m] springs closer than this resist no pitch that a vehicle would show
constexpr double kFarAway = 0.75;    // [m] axle-box springs stand up to 0.6 m from their axle
constexpr double kAxlesApart = 0.3;  // [m] the smallest wheels of a railway are larger

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// 1234.5678 mm -> "1.235 m": for people.
std::string metres(double value) { return formatQuantity(std::round(1e3 * value) / 1e3, Dimension::kLength); }

/// Where a spring takes hold of a body.
struct Grip {
  double x = 0.0;    // [m]
  double arm = 0.0;  // [m] from the body's centre of gravity
};

std::vector<std::vector<Grip>> gripsOf(const Topology& topology) {
  std::vector<std::vector<Grip>> grips(topology.bodies.size());
  for (const TopologySuspension& each : topology.suspensions) {
    if (!(each.stiffness > 0.0)) continue;
    const auto add = [&](int body, double arm) { grips[at(body)].push_back({topology.bodies[at(body)].x + arm, arm}); };
    add(each.upper, each.arm_upper);
    if (each.lower_body >= 0) add(each.lower_body, each.arm_lower);
  }
  return grips;
}

/// The warnings of a vehicle; those of equal vehicles of a train, which stand in one line of one file, once.
class GeometryWarnings {
 public:
  GeometryWarnings(const Vehicle& vehicle, const Topology& topology, const Rest& rest)
      : vehicle_(vehicle), topology_(topology), rest_(rest) {}

  Warnings run() {
    freePitches();
    farSuspensions();
    samePlaces();
    overlaps();
    return std::move(warnings_);
  }

 private:
  /// Whether it is the first of equal vehicles.
  /// @param beside  the other part that it is about, if any
  bool isNew(WarningCode code, const Origin& origin, const Origin& beside = {}) {
    return origin.line == 0 || seen_.emplace(code, origin.file, origin.line, beside.file, beside.line).second;
  }

  template <class Part>
  void add(WarningCode code, const Part& part, std::string message, std::string remedy, std::optional<double> value) {
    Warning& made = warnings_.emplace_back();
    made.code = code;
    made.place = part.origin;
    made.subject = part.name;
    made.message = std::move(message);
    made.remedy = std::move(remedy);
    made.value = value;
    if (value) made.unit = describe(Dimension::kLength).siUnit;
  }

  void freePitches() {
    const std::vector<std::vector<Grip>> grips = gripsOf(topology_);
    for (std::size_t b = 0; b < topology_.bodies.size(); ++b) {
      const TopologyBody& body = topology_.bodies[b];
      if (body.pitch_index < 0 || rest_.pitch_stiffness[b] > 0.0) continue;
      if (grips[b].empty()) {
        if (!isNew(WarningCode::kFreePitch, body.origin)) continue;
        add(WarningCode::kFreePitch, body, "may pitch, but no spring holds it",
            "add a spring, or leave pitch out of its motion", std::nullopt);
        continue;
      }
      const auto [first, last] = std::minmax_element(grips[b].begin(), grips[b].end(),
                                                     [](const Grip& a, const Grip& c) { return a.arm < c.arm; });
      // Without a motion z the body turns about its centre of gravity, else about the springs.
      const double lever = body.z_index >= 0 ? last->arm - first->arm : std::max(-first->arm, last->arm);
      if (lever > kOnePlace || !isNew(WarningCode::kFreePitch, body.origin)) continue;
      add(WarningCode::kFreePitch, body,
          "may pitch, but all its springs stand at x = " + metres(first->x) + " and nothing resists",
          "give each spring its x, or leave pitch out of its motion", first->x);
    }
  }

  void farSuspensions() {
    for (const TopologySuspension& each : topology_.suspensions) {
      if (each.lower_wheelset < 0) continue;
      const TopologyWheelset& wheelset = topology_.wheelsets[at(each.lower_wheelset)];
      const double distance = std::abs(each.x - wheelset.x);
      if (distance <= kFarAway || !isNew(WarningCode::kFarFromWheelset, each.origin)) continue;
      add(WarningCode::kFarFromWheelset, each,
          "stands at x = " + metres(each.x) + ", " + metres(distance) + " from its wheelset \"" + wheelset.name +
              "\" at x = " + metres(wheelset.x),
          "give it the x of the wheelset", distance);
    }
  }

  void samePlaces() {
    std::vector<const TopologyWheelset*> by_x;
    for (const TopologyWheelset& each : topology_.wheelsets) by_x.push_back(&each);
    std::stable_sort(by_x.begin(), by_x.end(),
                     [](const TopologyWheelset* a, const TopologyWheelset* b) { return a->x > b->x; });
    for (std::size_t j = 1; j < by_x.size(); ++j) {
      const double distance = by_x[j - 1]->x - by_x[j]->x;
      if (distance >= kAxlesApart) continue;
      // At the later one in the file: the x of the first is probably right.
      const bool ordered = by_x[j - 1]->origin.line <= by_x[j]->origin.line;
      const TopologyWheelset& first = ordered ? *by_x[j - 1] : *by_x[j];
      const TopologyWheelset& second = ordered ? *by_x[j] : *by_x[j - 1];
      const std::string where = distance < kOnePlace ? "stands where" : "stands " + metres(distance) + " from where";
      if (!isNew(WarningCode::kSamePlace, second.origin, first.origin)) continue;
      add(WarningCode::kSamePlace, second,
          where + " \"" + first.name + "\" stands, at x = " + metres(first.x) + "; wheels of two axles need more room",
          "give each axle its own x", distance);
    }
  }

  /// What a vehicle of a train holds along x.
  struct Extent {
    double rear = std::numeric_limits<double>::infinity();
    double front = -std::numeric_limits<double>::infinity();
    void hold(double x) {
      rear = std::min(rear, x);
      front = std::max(front, x);
    }
  };

  [[nodiscard]] std::map<std::string_view, Extent> extents() const {
    std::map<std::string_view, Extent> extents;
    const auto unitOf = [](const std::string& part) { return std::string_view(part).substr(0, part.find('.')); };
    for (const TopologyBody& each : topology_.bodies) extents[unitOf(each.name)].hold(each.x);
    for (const TopologyWheelset& each : topology_.wheelsets) extents[unitOf(each.name)].hold(each.x);
    for (const TopologySuspension& each : topology_.suspensions) {
      // A coupling belongs to both its vehicles, each end to one.
      const TopologyBody& upper = topology_.bodies[at(each.upper)];
      extents[unitOf(upper.name)].hold(upper.x + each.arm_upper);
      if (each.lower_body < 0) continue;
      const TopologyBody& lower = topology_.bodies[at(each.lower_body)];
      extents[unitOf(lower.name)].hold(lower.x + each.arm_lower);
    }
    return extents;
  }

  void overlaps() {
    if (vehicle_.units.size() < 2) return;
    std::map<std::string_view, Extent> along = extents();
    for (std::size_t k = 1; k < vehicle_.units.size(); ++k) {
      const TrainUnit& ahead = vehicle_.units[k - 1];
      const TrainUnit& behind = vehicle_.units[k];
      const double overlap = along[behind.name].front - along[ahead.name].rear;
      if (!(overlap > kOnePlace) || !isNew(WarningCode::kOverlap, behind.origin, ahead.origin)) continue;
      add(WarningCode::kOverlap, behind,
          "stands " + metres(overlap) + " deep in \"" + ahead.name +
              "\", which ends at x = " + metres(along[ahead.name].rear),
          "take a larger spacing", overlap);
    }
  }

  const Vehicle& vehicle_;
  const Topology& topology_;
  const Rest& rest_;
  Warnings warnings_;
  std::set<std::tuple<WarningCode, std::string, int, std::string, int>> seen_;
};

}  // namespace

Warnings geometryWarnings(const Vehicle& vehicle, const Topology& topology, const Rest& rest) {
  return GeometryWarnings(vehicle, topology, rest).run();
}

}  // namespace vehicle
