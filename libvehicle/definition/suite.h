#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libvehicle/definition/origin.h"

namespace vehicle {

/// A file named by another file, as written there; relative names count from the naming file's folder.
struct FileReference {
  std::string file;
  Origin origin;
  bool operator==(const FileReference&) const = default;
};

struct NamedChoice {
  std::string name;
  Origin origin;
  bool operator==(const NamedChoice&) const = default;
};

/// `count` speeds from `from` to `to`, evenly spaced, both ends included.
struct SpeedRange {
  double from = 0.0;  // [m/s]
  double to = 0.0;    // [m/s]
  int count = 1;      // >= 1; 1 gives `from`
  Origin origin;
  bool operator==(const SpeedRange&) const = default;
};

/// Vehicles, scenarios, speeds, forms and methods, all crossed.
struct Suite {
  std::string name;
  std::string title;
  std::string source;
  std::vector<FileReference> vehicles;
  std::vector<FileReference> scenarios;
  std::vector<SpeedRange> speeds;   // empty: the scenarios' own
  std::vector<NamedChoice> forms;   // empty: all that fit
  std::vector<NamedChoice> methods; // empty: all that fit
  Origin origin;
  bool operator==(const Suite&) const = default;
};

/// All speeds of the suite in order [m/s]; end points are exactly those given.
[[nodiscard]] std::vector<double> speedsOf(const Suite& suite);

[[nodiscard]] ProblemList check(const Suite& suite);

}  // namespace vehicle
