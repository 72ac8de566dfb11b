#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>

namespace vehicle {

/// All bytes of a file, or why it has none to give.
struct FileBytes {
  std::string bytes;      // empty where there is an error
  std::error_code error;  // the system's reason; std::errc::file_too_large where it has more than may be read
};

/// Reads to the end, whatever size the system names: files of /proc have a size of 0 and text all the same.
/// @param most  bytes that may be read: a device without end must not take the memory of the machine
[[nodiscard]] FileBytes readBytes(const std::filesystem::path& path, std::size_t most);

}  // namespace vehicle
