#pragma once

#include <optional>
#include <string>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/vehicle.h"
#include "libvehicle/diagnostics/warning.h"
#include "libvehicle/xml/file_source.h"

namespace vehicle {

/// What `check` finds in a file.
struct CheckedFile {
  ProblemList problems;  // empty: the command that takes the file will not refuse it
  Warnings warnings;
  std::optional<Vehicle> vehicle;    // of a vehicle or train in order
  std::optional<Scenario> scenario;  // of a scenario in order
};

/// Judges a file of any kind with all files that it names, as far as the command that takes it would refuse it before
/// it computes: `study` before the first design, `validate` before the first run, `info`, `modes` and `simulate` before
/// they build equations. The same functions decide there.
[[nodiscard]] CheckedFile checkFile(const std::string& path, FileSource& files);

}  // namespace vehicle
