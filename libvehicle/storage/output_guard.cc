#include "libvehicle/storage/output_guard.h"

#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "libvehicle/storage/atomic_file.h"
#include "libvehicle/storage/database_files.h"
#include "libvehicle/storage/file_lock.h"
#include "libvehicle/storage/output_folder.h"

namespace vehicle {

namespace fs = std::filesystem;

namespace {

constexpr const char* kOther = "name another file";

[[noreturn]] void refuse(const std::string& message) { throw std::invalid_argument(message); }

void requireEnding(const fs::path& file, const std::string& option, OutputKind kind) {
  std::string known;
  for (const OutputEnding& each : infoOf(kind).endings) {
    if (endingOf(file) == each.ending) return;
    known += fmt::format("{}{} ({})", known.empty() ? "" : " or ", each.ending, each.meaning);
  }
  refuse(fmt::format("{} {}: extension \"{}\" is unknown; name it {}", option, file.string(), file.extension().string(),
                     known));
}

/// A regular file, or a name that is free.
/// @returns whether it is there
bool requireFile(const fs::path& file, const std::string& option) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (fs::is_directory(status)) refuse(fmt::format("{} {}: is a folder; name a file in it", option, file.string()));
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    refuse(fmt::format("{} {}: is a device or pipe; name a regular file", option, file.string()));
  }
  return fs::exists(status);
}

bool isEmpty(const fs::path& file) {
  std::error_code error;
  return fs::file_size(file, error) == 0 && !error;
}

void requireWritable(const fs::path& file) { const AtomicFile opened_and_given_up(file); }

/// A new database takes the names of its companions too, and a file of the user's may have one of them.
void requireCompanions(const fs::path& file, const std::string& option) {
  for (const std::string_view ending : kCompanionEndings) {
    const fs::path companion = companionOf(file, ending);
    if (isCompanion(companion, ending)) continue;
    refuse(fmt::format("{} {}: {} is there and belongs to no database; move it away, or {}", option, file.string(),
                       companion.string(), kOther));
  }
}

}  // namespace

void OutputGuard::protect(const fs::path& file, const std::string& what) { add(file, {file.string(), "", what, ""}); }

void OutputGuard::protectDatabase(const fs::path& file, const std::string& what) {
  const Entry entry{file.string(), "", what, ""};
  add(file, entry);
  addCompanions(file, entry);
}

void OutputGuard::claim(const fs::path& file, const std::string& option, OutputKind kind) {
  add(file, {file.string(), option, "", ""});
  requireEnding(file, option, kind);
  requireReplaceable(file, option, kind);
  requireWritable(file);
}

void OutputGuard::claimDatabase(const fs::path& file, const std::string& option) {
  const Entry entry{file.string(), option, "", ""};
  add(file, entry);
  requireEnding(file, option, OutputKind::kDatabase);
  addCompanions(file, entry);
  if (requireFile(file, option) && !isEmpty(file)) {
    if (overwrite_ == Overwrite::kOwnFiles) {
      refuse(fmt::format("{}: {} exists already; go on with it by --resume, begin it anew by --overwrite, or {}",
                         option, file.string(), kOther));
    }
    if (!isOurs(file, OutputKind::kDatabase)) {
      refuse(fmt::format("{} {}: exists and is no {}, and --overwrite replaces nothing else; {}", option, file.string(),
                         infoOf(OutputKind::kDatabase).name, kOther));
    }
  }
  requireCompanions(file, option);
  requireWritable(file);
  const FileLock nobody_writes_it(followed(file));
}

void OutputGuard::resumeDatabase(const fs::path& file, const std::string& option) {
  const Entry entry{file.string(), option, "", ""};
  add(file, entry);
  requireEnding(file, option, OutputKind::kDatabase);
  addCompanions(file, entry);
  if (requireFile(file, option)) return;
  requireCompanions(file, option);
  requireWritable(file);
}

void OutputGuard::claimFolder(const fs::path& folder, const std::string& option, OutputKind kind,
                              const std::vector<std::string>& names) {
  if (folder.empty()) refuse(fmt::format("{}: no folder is named", option));
  std::error_code ignored;
  const fs::file_status status = fs::status(folder, ignored);
  if (fs::exists(status) && !fs::is_directory(status)) {
    refuse(fmt::format("{} {}: is a file; name a folder", option, folder.string()));
  }
  if (!fs::exists(status)) {
    for (const fs::path& missing : missingFolders(folder)) add(missing, {folder.string(), option, "", ""});
  }
  for (const std::string& name : names) {
    const fs::path file = folder / name;
    add(file, {file.string(), option, "", ""});
    requireReplaceable(file, option, kind);
  }
  requireFolderWritable(folder);
}

void OutputGuard::requireReplaceable(const fs::path& file, const std::string& option, OutputKind kind) const {
  if (!requireFile(file, option) || overwrite_ == Overwrite::kAnyFile || isEmpty(file) || isOurs(file, kind)) return;
  refuse(fmt::format("{} {}: exists and is no {} that this program wrote; {}, or replace it by --overwrite", option,
                     file.string(), infoOf(kind).name, kOther));
}

void OutputGuard::add(const fs::path& file, const Entry& entry) {
  const auto [known, fresh] = entries_.try_emplace(identityOf(file), entry);
  if (fresh) {
    const fs::path database = entry.option.empty() ? fs::path() : databaseOfCompanion(followed(file));
    if (database.empty() || !entry.companion.empty()) return;
    refuse(fmt::format("{} {}: is a companion of the database {}; {}", entry.option, entry.path, database.string(),
                       kOther));
  }
  const Entry& other = known->second;
  if (other.option.empty() && entry.option.empty()) return;  // read twice
  const auto called = [](const Entry& each) {
    const std::string role = each.option.empty() ? each.what : each.option;
    if (each.companion.empty()) return fmt::format("{} {}", role, each.path);
    return fmt::format("{}, a companion of {} {}", each.path, role, each.companion);
  };
  // The sentence is about the output; of two outputs, about the later one.
  const Entry& output = entry.option.empty() ? other : entry;
  const Entry& taken = entry.option.empty() ? entry : other;
  if (output.option == taken.option && output.path == taken.path) {
    refuse(fmt::format("{} {} is given twice", output.option, output.path));
  }
  refuse(fmt::format("{}{} is the same file as {}; {}", called(output), output.companion.empty() ? "" : ",",
                     called(taken), kOther));
}

void OutputGuard::addCompanions(const fs::path& file, const Entry& database) {
  for (const std::string_view ending : kCompanionEndings) {
    const fs::path companion = companionOf(followed(file), ending);
    add(companion, {companion.string(), database.option, database.what, database.path});
  }
}

}  // namespace vehicle
