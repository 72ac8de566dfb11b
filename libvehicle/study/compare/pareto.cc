#include "libvehicle/study/compare/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace vehicle {

namespace {

bool isFinite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double each) { return std::isfinite(each); });
}

bool precedes(std::span<const double> a, std::span<const double> b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

std::span<const double> rowOf(std::span<const double> values, std::size_t objectives, std::size_t row) {
  return values.subspan(row * objectives, objectives);
}

void requireTable(const char* caller, std::span<const double> values, std::size_t objectives) {
  if (objectives == 0 || values.size() % objectives != 0 || !isFinite(values)) {
    throw std::invalid_argument(std::string(caller) + ": values must be whole rows of finite objectives");
  }
}

}  // namespace

bool dominates(std::span<const double> a, std::span<const double> b) {
  bool better = false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] > b[i]) return false;
    better = better || a[i] < b[i];
  }
  return better;
}

bool ParetoFront::add(std::uint64_t design, std::span<const double> values) {
  if (values.size() != objectives_) throw std::invalid_argument("ParetoFront: another number of objectives");
  if (!isFinite(values)) return false;
  const auto place =
      std::lower_bound(members_.begin(), members_.end(), values,
                       [](const Member& a, std::span<const double> b) { return precedes(a.objectives, b); });
  if (place != members_.end() && std::equal(values.begin(), values.end(), place->objectives.begin())) return false;
  // Only what precedes can dominate, only what follows can be dominated. On a front of two objectives the second falls
  // as the first rises, so the nearest one before tells for all of them.
  const auto first = objectives_ == 2 && place != members_.begin() ? place - 1 : members_.begin();
  for (auto each = first; each != place; ++each) {
    if (dominates(each->objectives, values)) return false;
  }
  const auto begin = place - members_.begin();
  auto end = place;
  if (objectives_ == 2) {
    while (end != members_.end() && dominates(values, end->objectives)) ++end;
    members_.erase(place, end);
  } else {
    members_.erase(
        std::remove_if(place, members_.end(), [&](const Member& each) { return dominates(values, each.objectives); }),
        members_.end());
  }
  members_.insert(members_.begin() + begin, Member{design, {values.begin(), values.end()}});
  return true;
}

std::vector<std::size_t> paretoRanks(std::span<const double> values, std::size_t objectives) {
  requireTable("paretoRanks", values, objectives);
  const std::size_t designs = values.size() / objectives;
  std::vector<std::size_t> order(designs);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return precedes(rowOf(values, objectives, a), rowOf(values, objectives, b));
  });
  // In this order nobody dominates a predecessor. A design dominated by front k is dominated by all before it, so the
  // first front that does not is found by halving.
  std::vector<std::vector<std::size_t>> fronts;
  std::vector<std::size_t> ranks(designs, 0);
  for (const std::size_t design : order) {
    const std::span<const double> own = rowOf(values, objectives, design);
    const auto beats = [&](const std::vector<std::size_t>& front) {
      // With two objectives the last one that entered has the least second objective of its front.
      if (objectives == 2) return dominates(rowOf(values, objectives, front.back()), own);
      return std::any_of(front.rbegin(), front.rend(),
                         [&](std::size_t member) { return dominates(rowOf(values, objectives, member), own); });
    };
    const auto found = std::partition_point(fronts.begin(), fronts.end(), beats);
    ranks[design] = static_cast<std::size_t>(found - fronts.begin());
    if (found == fronts.end()) {
      fronts.push_back({design});
    } else {
      found->push_back(design);
    }
  }
  return ranks;
}

std::vector<double> crowdingDistances(std::span<const double> values, std::size_t objectives) {
  requireTable("crowdingDistances", values, objectives);
  const std::size_t designs = values.size() / objectives;
  std::vector<double> distances(designs, 0.0);
  std::vector<std::size_t> order(designs);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t k = 0; k < objectives && designs > 0; ++k) {
    const auto value = [&](std::size_t position) { return values[order[position] * objectives + k]; };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return values[a * objectives + k] < values[b * objectives + k];
    });
    const double extent = value(designs - 1) - value(0);
    distances[order.front()] = std::numeric_limits<double>::infinity();
    distances[order.back()] = std::numeric_limits<double>::infinity();
    if (!(extent > 0.0)) continue;
    for (std::size_t i = 1; i + 1 < designs; ++i) distances[order[i]] += (value(i + 1) - value(i - 1)) / extent;
  }
  return distances;
}

double hypervolume(std::span<const double> values, std::pair<double, double> reference) {
  requireTable("hypervolume", values, 2);
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < values.size(); i += 2) {
    if (values[i] < reference.first && values[i + 1] < reference.second) points.emplace_back(values[i], values[i + 1]);
  }
  std::sort(points.begin(), points.end());
  double area = 0.0;
  double height = reference.second;
  for (const auto& [x, y] : points) {
    if (y >= height) continue;
    area += (reference.first - x) * (height - y);
    height = y;
  }
  return area;
}

}  // namespace vehicle
