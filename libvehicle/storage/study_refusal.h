#pragma once

#include <filesystem>
#include <string>

#include "libvehicle/storage/sqlite_handle.h"

namespace vehicle {

// A study's database that cannot be read is a wrong input as any other file. Private to this room.

/// @throws InvalidInput  FILE: error: MESSAGE; REMEDY
[[noreturn]] void refuseDatabase(const std::string& shown, const std::string& message, const std::string& remedy);

/// @throws InvalidInput  the file is missing, a folder, a device or pipe
void requireDatabaseFile(const std::filesystem::path& path);

/// What SQLite said when it was to open or read the file.
/// @throws InvalidInput  the file is none of SQLite's, damaged or unreadable
/// @throws RunFailed     another process stands in the way, or memory is short
[[noreturn]] void refuseReading(const std::string& shown, const SqliteError& error);

}  // namespace vehicle
