#include "libvehicle/definition/notes.h"

#include <algorithm>
#include <set>
#include <utility>

#include "libvehicle/definition/judge.h"

namespace vehicle {

namespace {

/// One note for all of these places, at the first of them.
void add(std::vector<Place> places, const std::string& what, const std::string& meaning, std::vector<Note>& notes) {
  if (places.empty()) return;
  std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.line < b.line; });
  const std::vector<Place> others(places.begin() + 1, places.end());
  notes.push_back({places.front(), what + andIn(others) + ": " + meaning});
}

template <class Member>
void collect(const std::vector<Member>& members, std::vector<Place>& places) {
  for (const Member& each : members) {
    if (each.rail != RailSide::kBoth) places.push_back(each.origin);
  }
}

void noteOneRail(const Track& track, std::vector<Note>& notes) {
  std::vector<Place> places;
  collect(track.harmonics, places);
  collect(track.dips, places);
  collect(track.bumps, places);
  collect(track.ramps, places);
  add(std::move(places), "rail=\"left\" or \"right\"",
      "planar forms take the mean of both rails, so half of the height counts", notes);
}

}  // namespace

std::string Note::line() const {
  std::string line = place.file;
  if (place.line > 0) line.append(1, ':').append(std::to_string(place.line));
  return line.empty() ? text : line.append(": ").append(text);
}

std::vector<Note> notesOn(const Scenario& scenario) {
  std::vector<Note> notes;
  if (scenario.track) {
    noteOneRail(*scenario.track, notes);
    if (scenario.track->fade_in && scenario.track->harmonics.empty()) {
      notes.push_back({scenario.track->origin, "fade_in is not used: it acts on harmonics, and the track has none"});
    }
  }
  if (scenario.rig && !scenario.run.distance && scenario.run.speed > 0.0) {
    notes.push_back({scenario.run.origin, "speed is not used: the wheels of a rig do not roll"});
  }
  return notes;
}

std::vector<Note> notesOn(const std::vector<Scenario>& scenarios) {
  std::vector<Note> notes;
  std::set<std::string> lines;
  for (const Scenario& scenario : scenarios) {
    for (Note& each : notesOn(scenario)) {
      if (lines.insert(each.line()).second) notes.push_back(std::move(each));
    }
  }
  return notes;
}

std::vector<Note> notesOn(const Vehicle& vehicle) {
  std::vector<Place> places;
  for (const Wheelset& each : vehicle.wheelsets) {
    // Equal vehicles of a train come from one place.
    const bool known = each.origin.line > 0 && std::any_of(places.begin(), places.end(), [&](const Place& place) {
                         return place.file == each.origin.file && place.line == each.origin.line;
                       });
    if (each.hertz_constant && !known) places.push_back(each.origin);
  }
  std::vector<Note> notes;
  add(std::move(places), "hertz_constant", "the contact is linearised at the static load and cannot open", notes);
  return notes;
}

}  // namespace vehicle
