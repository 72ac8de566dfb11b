#pragma once

#include <optional>
#include <string>
#include <utility>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/suite.h"
#include "libvehicle/definition/vehicle.h"
#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/project/settings.h"
#include "libvehicle/xml/file_source.h"

namespace vehicle {

/// Reads the files that a study or suite names, and collects what is wrong with them: a file that cannot be read or is
/// of another kind is reported where it is named, what is wrong inside it at its own place. A name that is missing or
/// could not be read leads nowhere and is reported by the reader of the study or suite.
class NamedFiles {
 public:
  /// @param holder  element that names them: "suite"
  /// @param files     outlives the object
  /// @param settings  are applied to what has been read; outlive the object
  NamedFiles(std::string holder, FileSource& files, Settings& settings)
      : holder_(std::move(holder)), files_(files), settings_(settings) {}

  /// A vehicle, or a train as one vehicle.
  [[nodiscard]] std::optional<Vehicle> vehicle(const FileReference& reference);
  [[nodiscard]] std::optional<Scenario> scenario(const FileReference& reference);

  [[nodiscard]] const ProblemList& problems() const { return problems_; }

 private:
  std::string holder_;
  FileSource& files_;
  Settings& settings_;
  ProblemList problems_;
};

}  // namespace vehicle
