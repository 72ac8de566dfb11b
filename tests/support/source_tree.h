#pragma once

#include <string>

namespace vehicle::test {

/// A file or folder of the sources that this program was built from, as an absolute path. That place is compiled into
/// source_tree.cc alone, so that a compiler cache serves every checkout with all other objects.
/// @param relative  as the repository names it: "models/vehicle.xsd"; "" is the top folder itself
[[nodiscard]] std::string sourcePath(const std::string& relative = "");

}  // namespace vehicle::test
