#include "libvehicle/study/compare/pareto.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace vehicle {

namespace {

bool isFinite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double each) { return std::isfinite(each); });
}

bool precedes(std::span<const double> a, std::span<const double> b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
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

}  // namespace vehicle
