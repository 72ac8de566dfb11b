#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/definition/vehicle.h"

namespace vehicle {

/// A named part of a vehicle, whatever its kind: all of them share one space of names.
struct Part {
  std::string_view kind;  // "body"
  std::string path;       // "<vehicle><group><body>"
  std::string name;
  Origin place;
};

/// All named parts in the order of the file (by line, then by kind).
[[nodiscard]] std::vector<Part> partsOf(const Vehicle& vehicle);

/// Path of an element inside a vehicle, through its group if it stands in one.
[[nodiscard]] std::string pathOf(std::string_view kind, std::string_view group = "");

/// "a body", "an element".
[[nodiscard]] std::string withArticle(std::string_view kind);

/// What ties the parts together: names that are given twice, references that lead nowhere or to the wrong
/// kind, parts that stand on nothing. Where a name or a reference could not be read, or is wrong itself, what it may
/// have meant is not reported a second time.
[[nodiscard]] ProblemList checkTies(const Vehicle& vehicle);

}  // namespace vehicle
