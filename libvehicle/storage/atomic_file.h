#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace vehicle {

/// A file that appears whole or not at all. It is written under a temporary name in the same folder,
/// `<name>.<process>-<n>.vehicle-tmp`, flushed to the disk and renamed by publish(); renaming within a folder is
/// atomic, so a reader, and whoever looks after a crash or a kill, sees the old file or the new one. A killed
/// process may leave its temporary file behind, never half a result.
///
/// A symbolic link is followed: the file that it names is replaced or made, not the link.
class AtomicFile {
 public:
  /// @throws RunFailed if the folder is missing or may not be written, or `path` is no regular file; names the path
  ///         and the system's reason
  explicit AtomicFile(const std::filesystem::path& path);
  /// Without publish(): removes the temporary file, leaves the old one.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Appends bytes.
  /// @throws RunFailed (disk full, file too large, ...)
  void write(std::string_view bytes);
  /// The same at a place of its own, counted from the begin; the file grows to hold it.
  void writeAt(std::uint64_t offset, std::string_view bytes);
  /// Bytes that were written there; zeros where nothing was.
  /// @throws RunFailed
  void readAt(std::uint64_t offset, std::span<char> bytes) const;

  /// Flushes to the disk and closes; nothing may be written afterwards. Called for several files before the first is
  /// published, it leaves nothing that may fail but the renaming.
  /// @throws RunFailed
  void finish();
  /// Finishes and renames.
  /// @throws RunFailed; the old file then stands
  void publish();

 private:
  [[noreturn]] void fail(const char* action, int error, const char* remedy = "") const;

  std::string shown_;  // the path as the caller gave it, for messages
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;
};

/// Writes a whole file so.
/// @throws RunFailed; the old file then stands
void writeAtomically(const std::filesystem::path& path, std::string_view text);

/// Makes a new name in the folder of a file outlast a power cut. Some file systems refuse that: then nothing happens,
/// the file itself is safe already.
void flushFolderOf(const std::filesystem::path& file);

}  // namespace vehicle
