#pragma once

#include <string>
#include <utility>
#include <vector>

#include "libvehicle/result/time_history.h"

namespace vehicle {

/// A file that a run was made from: its name as given and its whole text.
struct InputFile {
  std::string name;
  std::string text;
  bool operator==(const InputFile&) const = default;
};

/// What is kept of one run: enough to repeat it.
struct RunRecord {
  TimeHistory history;
  std::vector<std::pair<std::string, std::string>> attributes;  // name, value: version, form, method, step, seed, ...
  std::vector<InputFile> inputs;                                // vehicle and scenario files
};

/// Throws unless the history has columns and every value is finite: a file must never say "nan".
/// @throws std::invalid_argument naming column and time
void requireStorable(const TimeHistory& history);

}  // namespace vehicle
