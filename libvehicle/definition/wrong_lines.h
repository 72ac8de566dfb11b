#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "libvehicle/definition/origin.h"

namespace vehicle {

/// The lines of files in which something is wrong. Private to this room.
class WrongLines {
 public:
  explicit WrongLines(const ProblemList& problems) {
    for (const Problem& each : problems) lines_.emplace(each.place.file, each.place.line);
  }

  /// Whether a problem lies in one of the lines of that part.
  [[nodiscard]] bool touch(const Origin& part) const {
    if (lines_.contains({part.file, part.line})) return true;
    if (!part.text) return false;
    for (const AttributeText& each : part.text->attributes) {
      if (each.given && lines_.contains({part.file, each.line})) return true;
    }
    return false;
  }

  /// Also erases parts of which a value could not be read.
  template <class Part>
  void eraseFrom(std::vector<Part>& parts) const {
    std::erase_if(parts, [this](const Part& each) { return touch(each.origin) || !each.origin.knowsAll(); });
  }

 private:
  std::set<std::pair<std::string, int>> lines_;
};

}  // namespace vehicle
