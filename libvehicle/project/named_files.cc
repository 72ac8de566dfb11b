#include "libvehicle/project/named_files.h"

#include "libvehicle/xml/named_file.h"
#include "libvehicle/xml/reader.h"

namespace vehicle {

std::optional<Vehicle> NamedFiles::vehicle(const FileReference& reference) {
  if (!reference.origin.knows("file") || reference.file.empty()) return std::nullopt;
  const ProblemList here = checkNamedFile(holder_, reference, {FileKind::kVehicle, FileKind::kTrain}, files_);
  problems_.append(here);
  if (!here.empty()) return std::nullopt;
  Outcome<Vehicle> read = readVehicle(resolvePath(reference.origin.file, reference.file), files_);
  problems_.append(read.problems);
  if (read.value) settings_.apply(*read.value);
  return std::move(read.value);
}

std::optional<Scenario> NamedFiles::scenario(const FileReference& reference) {
  if (!reference.origin.knows("file") || reference.file.empty()) return std::nullopt;
  const ProblemList here = checkNamedFile(holder_, reference, {FileKind::kScenario}, files_);
  problems_.append(here);
  if (!here.empty()) return std::nullopt;
  Outcome<Scenario> read = readScenario(resolvePath(reference.origin.file, reference.file), files_);
  problems_.append(read.problems);
  if (read.value) settings_.apply(*read.value);
  return std::move(read.value);
}

}  // namespace vehicle
