#pragma once

#include <filesystem>
#include <vector>

namespace vehicle {

/// The folders that would have to be made for a path, the outermost first.
[[nodiscard]] std::vector<std::filesystem::path> missingFolders(const std::filesystem::path& folder);

/// Whether files could be written in a folder, which is made for the question and removed again where it is missing.
/// @throws RunFailed  names the path and the system's reason
void requireFolderWritable(const std::filesystem::path& folder);

/// @throws RunFailed  names the path and the system's reason
void makeFolder(const std::filesystem::path& folder);

}  // namespace vehicle
