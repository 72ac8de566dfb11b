#include "libvehicle/xml/file_source.h"

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/diagnostics/file_bytes.h"

namespace vehicle {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{1} << 28;

Outcome<std::string> refuse(const std::string& path, std::string message, std::string remedy) {
  Outcome<std::string> outcome;
  outcome.problems.add({path, 0}, "", std::move(message), std::move(remedy));
  return outcome;
}

Outcome<std::string> tooLarge(const std::string& path) {
  return refuse(path, fmt::format("is larger than {} MiB", kMostBytes >> 20), "make several files of it");
}

Outcome<std::string> readFromDisk(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    const std::string reason = error ? error.message() : std::strerror(ENOENT);
    return refuse(path, fmt::format("cannot be read: {}", reason), "check the name of the file");
  }
  if (fs::is_directory(status)) return refuse(path, "is a folder", "name a file in it");
  if (!fs::is_regular_file(status)) {
    return refuse(path, "is no regular file", "copy what it gives into a file");
  }
  if (fs::file_size(path, error) > kMostBytes && !error) return tooLarge(path);
  FileBytes read = readBytes(path, kMostBytes);
  if (read.error == std::errc::file_too_large) return tooLarge(path);
  if (read.error) {
    return refuse(path, fmt::format("cannot be read: {}", read.error.message()), "check its permissions");
  }
  return {std::move(read.bytes), {}};
}

}  // namespace

FileSource::FileSource(const std::map<std::string, std::string>& texts) : reads_disk_(false) {
  for (const auto& [path, text] : texts) known_[keyOf(path)] = {text, {}};
}

void FileSource::hold(const std::string& path, std::string text) { known_[keyOf(path)] = {std::move(text), {}}; }

const Outcome<std::string>& FileSource::text(const std::string& path) {
  const auto [known, is_new] = known_.try_emplace(keyOf(path));
  if (is_new) {
    known->second = reads_disk_
                        ? readFromDisk(path)
                        : refuse(path, "is not among the files that are kept", "read the files from disk again");
  }
  return known->second;
}

std::string FileSource::keyOf(const std::string& path) const {
  return (reads_disk_ ? fs::absolute(path) : fs::path(path)).lexically_normal().string();
}

}  // namespace vehicle
