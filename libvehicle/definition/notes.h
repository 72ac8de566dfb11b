#pragma once

#include <string>
#include <vector>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/vehicle.h"

namespace vehicle {

/// What the program makes of a value of a file that a reader of the file may not expect. Nothing is wrong with it.
struct Note {
  Place place;
  std::string text;  // one sentence

  /// FILE:LINE: TEXT
  [[nodiscard]] std::string line() const;
};

/// What a planar run does not use of a scenario, or not as it stands there: members of one rail (half of them counts),
/// the speed of a rig, a fade_in without harmonics.
[[nodiscard]] std::vector<Note> notesOn(const Scenario& scenario);

/// Those on several scenarios, each line once.
[[nodiscard]] std::vector<Note> notesOn(const std::vector<Scenario>& scenarios);

/// A Hertz contact is linearised at the static load and cannot open.
[[nodiscard]] std::vector<Note> notesOn(const Vehicle& vehicle);

}  // namespace vehicle
