#include "libvehicle/storage/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/storage/file_identity.h"

namespace vehicle {

namespace fs = std::filesystem;

namespace {

constexpr const char* kUnchanged = "the file that stood there before is unchanged";

}  // namespace

AtomicFile::AtomicFile(const fs::path& path) : shown_(path.string()), target_(followed(path)) {
  std::error_code ignored;
  const fs::file_status status = fs::status(target_, ignored);
  if (fs::is_directory(status)) fail("cannot be written", EISDIR, "name a file in it");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    throw RunFailed(fmt::format("{}: cannot be written: it is a device or pipe; name a regular file", shown_));
  }
  // Renaming asks the folder for permission only: a file that its owner made read-only would be replaced.
  if (fs::exists(status) && ::access(target_.c_str(), W_OK) != 0) fail("cannot be replaced", errno);

  constexpr int kAttempts = 1000;
  for (int attempt = 0; attempt < kAttempts && descriptor_ < 0; ++attempt) {
    temporary_ = target_;
    temporary_ += fmt::format(".{}-{}.vehicle-tmp", ::getpid(), attempt);
    descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST && errno != EINTR) break;
  }
  if (descriptor_ < 0) fail("cannot be written", errno, "its folder must exist and be writable");
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::fail(const char* action, int error, const char* remedy) const {
  const std::string reason = std::generic_category().message(error);
  throw RunFailed(fmt::format("{}: {}: {}{}{}", shown_, action, reason, *remedy != '\0' ? "; " : "", remedy));
}

void AtomicFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot be written", errno, kUnchanged);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void AtomicFile::writeAt(std::uint64_t offset, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot be written", errno, kUnchanged);
    bytes.remove_prefix(static_cast<std::size_t>(written));
    offset += static_cast<std::uint64_t>(written);
  }
}

void AtomicFile::readAt(std::uint64_t offset, std::span<char> bytes) const {
  while (!bytes.empty()) {
    const ssize_t got = ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail("cannot be read back", errno, kUnchanged);
    if (got == 0) break;
    bytes = bytes.subspan(static_cast<std::size_t>(got));
    offset += static_cast<std::uint64_t>(got);
  }
  std::fill(bytes.begin(), bytes.end(), '\0');
}

void AtomicFile::finish() {
  if (descriptor_ < 0) return;
  // The data must be on the disk before the name points at them, or a power cut leaves an empty file under it.
  if (::fsync(descriptor_) != 0) fail("cannot be flushed", errno, kUnchanged);
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0) fail("cannot be closed", errno, kUnchanged);
}

void AtomicFile::publish() {
  finish();
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail("cannot be renamed into place", errno);
  temporary_.clear();

  flushFolderOf(target_);
}

void writeAtomically(const std::filesystem::path& path, std::string_view text) {
  AtomicFile file(path);
  file.write(text);
  file.publish();
}

void flushFolderOf(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); handle >= 0) {
    ::fsync(handle);
    ::close(handle);
  }
}

}  // namespace vehicle
