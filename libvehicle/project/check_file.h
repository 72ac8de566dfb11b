#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libvehicle/definition/notes.h"
#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/vehicle.h"
#include "libvehicle/diagnostics/warning.h"
#include "libvehicle/project/settings.h"
#include "libvehicle/xml/file_source.h"

namespace vehicle {

/// What `check` finds in a file.
struct CheckedFile {
  ProblemList problems = {};  // empty: the command that takes the file will not refuse it
  Warnings warnings = {};
  std::vector<Note> notes = {};
  std::optional<Vehicle> vehicle = {};    // of a vehicle, as far as it could be read, or of a train in order
  std::optional<Scenario> scenario = {};  // of a scenario, as far as it could be read
};

/// Judges a file of any kind with all files that it names, as far as the command that takes it would refuse it before
/// it computes: `study` before the first design, `validate` before the first run, `info`, `modes` and `simulate` before
/// they build equations. The same functions decide there.
/// All problems come in one pass: what is wrong with one part keeps no other from being judged.
/// @param settings  are applied to what has been read without problems; the caller asks requireRight() after all files
[[nodiscard]] CheckedFile checkFile(const std::string& path, FileSource& files, Settings& settings);
[[nodiscard]] CheckedFile checkFile(const std::string& path, FileSource& files);

/// What is wrong with a scenario beside a vehicle, both from checkFile(): checkTogether() of two files without problems;
/// of others the names that the vehicle does not have.
[[nodiscard]] ProblemList checkPair(const CheckedFile& vehicle, const CheckedFile& scenario);

}  // namespace vehicle
