#pragma once

#include <string>

namespace vehicle {

/// A named number that changes in time, with its SI unit: one column of a result, one state of a system.
struct Channel {
  std::string name;  // "<part>.<quantity>", e.g. "carbody.z"
  std::string unit;  // e.g. "m"
  bool operator==(const Channel&) const = default;
};

}  // namespace vehicle
