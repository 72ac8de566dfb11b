#include "libvehicle/definition/part_names.h"

#include <algorithm>

namespace vehicle {

PartNames::PartNames(const Vehicle& vehicle, const std::vector<Part>& parts) : parts_(parts) {
  for (const Part& part : parts) {
    by_name_.emplace(part.name, &part);
    if (part.name.empty() || !part.place.knows("name")) nameless_.insert(part.kind);
  }
  // That a vehicle has none of them at all is reported once, of the whole.
  if (vehicle.bodies.empty()) nameless_.insert("body");
  if (vehicle.wheelsets.empty()) nameless_.insert("wheelset");
  if (!vehicle.origin.text) return;
  for (const std::string& word : vehicle.origin.text->strange_words) strange_.insert(word);
}

Meaning PartNames::meaningOf(const Origin& from, std::string_view attribute, const std::string& name,
                             Kinds kinds) const {
  using enum Meaning::Kind;
  if (!from.knows(attribute)) return {kNotKnown, "", nullptr};
  const auto fits = [&](std::string_view kind) { return std::find(kinds.begin(), kinds.end(), kind) != kinds.end(); };
  const auto [begin, end] = by_name_.equal_range(name);
  for (auto each = begin; each != end; ++each) {
    if (fits(each->second->kind)) return {kExact, each->second->name, nullptr};
  }
  if (begin != end) return {kWrongKind, "", begin->second};
  if (isStrange(name) || std::any_of(nameless_.begin(), nameless_.end(), fits)) return {kNotKnown, "", nullptr};
  // Comparing every lost name with every name of a huge file would take minutes; nobody reads so many.
  constexpr std::size_t kMostSuggestions = 20;
  std::string key = name;
  for (const std::string_view kind : kinds) key += ' ' + std::string(kind);
  const auto [entry, is_new] = nearest_.try_emplace(std::move(key));
  if (is_new && nearest_.size() <= kMostSuggestions) {
    std::vector<std::string> candidates;
    for (const Part& part : parts_) {
      if (fits(part.kind)) candidates.push_back(part.name);
    }
    if (const auto nearest = nearestName(name, candidates)) entry->second = by_name_.find(*nearest)->first;
  }
  return {entry->second.empty() ? kNowhere : kMisspelt, entry->second, nullptr};
}

SuspensionEnds endsOf(const Suspension& suspension, const PartNames& names) {
  const Origin& from = suspension.origin;
  return {names.meaningOf(from, "element", suspension.element, {"element"}),
          names.meaningOf(from, "upper", suspension.upper, {"body"}),
          names.meaningOf(from, "lower", suspension.lower, {"body", "wheelset"})};
}

}  // namespace vehicle
