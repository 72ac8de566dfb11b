#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <string>

namespace vehicle {

/// Which file a name leads to: two names of one file (a symbolic link, a hard link, another spelling of the path) have
/// equal identities, so that what is read is never written over under another name. A file that does not exist yet is
/// identified by its nearest folder that does and the rest of its path.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;  // of the file, or of that folder
  std::string rest;         // of the path below that folder; "" where the file exists
  auto operator<=>(const FileIdentity&) const = default;
};

/// @throws std::filesystem::filesystem_error  the current folder has been removed
[[nodiscard]] FileIdentity identityOf(const std::filesystem::path& path);

/// The path with the symbolic links at its end followed, also where the last of them leads to no file yet. Links among
/// its folders are left to the system.
[[nodiscard]] std::filesystem::path followed(const std::filesystem::path& path);

/// The ending of a file's name in lower case, with its dot: ".csv" of "Run.CSV"; "" where there is none.
[[nodiscard]] std::string endingOf(const std::filesystem::path& path);

}  // namespace vehicle
