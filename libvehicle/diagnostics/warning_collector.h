#pragma once

#include <set>
#include <string>
#include <utility>

#include "libvehicle/diagnostics/warning.h"

namespace vehicle {

/// Warnings of several runs as one list: what is said of the vehicle itself once, of a motion with the run it is of.
class WarningCollector {
 public:
  /// @param run  stands before the subject of warnings that have a time: "at 80 km/h"; "" where there is one run
  void add(const Warnings& found, const std::string& run = {});
  [[nodiscard]] Warnings take() { return std::move(all_); }

 private:
  Warnings all_;
  std::set<std::string> texts_;
};

}  // namespace vehicle
