#pragma once

#include <span>
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

/// What is kept of one run beside its history: enough to repeat it.
struct RunDescription {
  std::vector<std::pair<std::string, std::string>> attributes;  // name, value: version, form, method, step, seed, ...
  std::vector<InputFile> inputs;                                // vehicle and scenario files
};

/// What is kept of one run.
struct RunRecord {
  TimeHistory history;
  std::vector<std::pair<std::string, std::string>> attributes;  // of its description
  std::vector<InputFile> inputs;
};

/// Throws unless every value of a sample is finite: a file must never say "nan".
/// @param columns, row  "time" first
/// @throws std::invalid_argument naming column and time
void requireStorable(const std::vector<Channel>& columns, std::span<const double> row);
/// The same of all samples; the history must have columns.
void requireStorable(const TimeHistory& history);

}  // namespace vehicle
