#pragma once

#include <array>
#include <filesystem>
#include <string_view>

namespace vehicle {

/// What may stand beside a database under its name: SQLite's write-ahead log, its index and the rollback journal, and
/// the lock of a study that is being written (file_lock.h).
inline constexpr std::array<std::string_view, 4> kCompanionEndings = {"-wal", "-shm", "-journal", "-lock"};

[[nodiscard]] std::filesystem::path companionOf(const std::filesystem::path& database, std::string_view ending);

/// The database whose companion a file is by its name and by what stands beside it; empty where it is none.
[[nodiscard]] std::filesystem::path databaseOfCompanion(const std::filesystem::path& file);

/// Whether a companion is what its name says, or empty, or not there: only such a file may go with its database.
[[nodiscard]] bool isCompanion(const std::filesystem::path& file, std::string_view ending);

}  // namespace vehicle
