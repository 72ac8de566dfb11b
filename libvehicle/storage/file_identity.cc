#include "libvehicle/storage/file_identity.h"

#include <sys/stat.h>

#include <algorithm>
#include <system_error>

namespace vehicle {

namespace fs = std::filesystem;

fs::path followed(const fs::path& path) {
  constexpr int kMostLinks = 40;  // Linux itself gives up there
  fs::path target = path;
  std::error_code error;
  for (int links = 0; links < kMostLinks && fs::is_symlink(fs::symlink_status(target, error)); ++links) {
    const fs::path named = fs::read_symlink(target, error);
    if (error) break;
    target = named.is_absolute() ? named : target.parent_path() / named;
  }
  return target;
}

FileIdentity identityOf(const fs::path& path) {
  if (path.empty()) return {};
  fs::path existing = fs::absolute(followed(path));
  fs::path rest;
  struct stat status {};
  while (::stat(existing.c_str(), &status) != 0) {
    const fs::path parent = existing.parent_path();
    if (parent == existing) break;  // not even "/" can be looked at
    if (existing.has_filename()) rest = rest.empty() ? existing.filename() : existing.filename() / rest;
    existing = parent;
  }
  return {static_cast<std::uint64_t>(status.st_dev), static_cast<std::uint64_t>(status.st_ino), rest.string()};
}

std::string endingOf(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return ending;
}

}  // namespace vehicle
