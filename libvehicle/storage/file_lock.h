#pragma once

#include <filesystem>

namespace vehicle {

/// The right to write a file, held by one process at a time: an flock() on `<path>-lock` beside it, which goes with the
/// process however that ends. The file of the lock is removed at the end; a killed process leaves it behind, empty, and
/// the next one takes it over.
class FileLock {
 public:
  /// @throws RunFailed if another process holds it, or the folder may not be written; names the path
  explicit FileLock(const std::filesystem::path& path);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::filesystem::path lock_;
  int descriptor_ = -1;
};

}  // namespace vehicle
