#pragma once

#include <filesystem>
#include <string>

#include "libvehicle/diagnostics/problem.h"

namespace vehicle {

/// All bytes of a file, at most 256 MiB, or the system's reason why not as a problem of that file.
[[nodiscard]] Outcome<std::string> readFile(const std::filesystem::path& path);

}  // namespace vehicle
