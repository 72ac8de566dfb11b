#include "libvehicle/storage/output_folder.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/storage/atomic_file.h"

namespace vehicle {

namespace fs = std::filesystem;

namespace {

/// Folders made for a question, removed at its end.
class MadeFolders {
 public:
  explicit MadeFolders(std::vector<fs::path> folders) : folders_(std::move(folders)) {}
  ~MadeFolders() {
    std::error_code ignored;
    for (auto each = folders_.rbegin(); each != folders_.rend(); ++each) fs::remove(*each, ignored);  // only if empty
  }
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;

 private:
  std::vector<fs::path> folders_;
};

}  // namespace

std::vector<fs::path> missingFolders(const fs::path& folder) {
  std::vector<fs::path> missing;
  std::error_code ignored;
  fs::path each = folder.has_filename() ? folder : folder.parent_path();
  for (; !each.empty() && !fs::exists(each, ignored) && each != each.parent_path(); each = each.parent_path()) {
    missing.push_back(each);
  }
  std::reverse(missing.begin(), missing.end());
  return missing;
}

void makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw RunFailed(fmt::format("{}: the folder cannot be made: {}", folder.string(), error.message()));
}

void requireFolderWritable(const fs::path& folder) {
  const MadeFolders passing(missingFolders(folder));
  makeFolder(folder);
  const AtomicFile opened_and_given_up(folder / "design.xml");
}

}  // namespace vehicle
