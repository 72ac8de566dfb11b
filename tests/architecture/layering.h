#pragma once

#include <filesystem>

#include "tests/architecture/house.h"

namespace vehicle::test {

/// Reads every #include under libvehicle/ and apps/:
///   - a room includes its own headers and those of the rooms that it USES, nothing along an undeclared arrow;
///   - a project header is included by its path from the root;
///   - a library's header stands only in rooms that declare the library, Simbody's in one file alone, those of the
///     command line only in apps; what a room uses PRIVATE never stands in its public headers;
///   - a header that is neither standard, POSIX, ours nor in the table is unknown.
[[nodiscard]] Violations wrongIncludes(const std::filesystem::path& root);

/// Folders under libvehicle/ that no vehicle_room() declares, files that no vehicle_files() lists, listed files that
/// do not exist.
[[nodiscard]] Violations wrongFiles(const std::filesystem::path& root);

/// C++ files under apps/, benchmarks/, libvehicle/ and tests/ that are longer than 400 lines.
[[nodiscard]] Violations longFiles(const std::filesystem::path& root);

/// Entries of the top folder that docs/architecture.md does not name and .gitignore does not ignore.
[[nodiscard]] Violations strayEntries(const std::filesystem::path& root);

}  // namespace vehicle::test
