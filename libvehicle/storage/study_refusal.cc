#include "libvehicle/storage/study_refusal.h"

#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"

namespace vehicle {

namespace {

constexpr const char* kStudyRemedy = "name a database that `vehicle study --output` wrote";
constexpr const char* kDamageRemedy = "go on with a copy, or begin a new study";

}  // namespace

void refuseDatabase(const std::string& shown, const std::string& message, const std::string& remedy) {
  ProblemList problems;
  problems.add({shown, 0}, "", message, remedy);
  throw InvalidInput(std::move(problems));
}

void requireDatabaseFile(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_regular_file(status)) return;
  if (fs::is_directory(status)) refuseDatabase(path.string(), "is a folder", "name a file in it");
  if (fs::exists(status)) refuseDatabase(path.string(), "is no regular file", kStudyRemedy);
  const std::error_code reason = error ? error : std::make_error_code(std::errc::no_such_file_or_directory);
  refuseDatabase(path.string(), "cannot be read: " + reason.message(), "check the name of the file");
}

void refuseReading(const std::string& shown, const SqliteError& error) {
  switch (error.code & 0xff) {
    case SQLITE_NOTADB:
      refuseDatabase(shown, "holds no study: it is no SQLite file", kStudyRemedy);
    case SQLITE_CORRUPT:
    case SQLITE_ERROR:  // a table of ours is missing
      refuseDatabase(shown, fmt::format("is damaged ({})", error.reason), kDamageRemedy);
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_AUTH:
      refuseDatabase(shown, "cannot be read: " + error.reason, "check its permissions");
    case SQLITE_IOERR:
      refuseDatabase(shown, "cannot be read: " + error.reason, kDamageRemedy);
    default:
      throw RunFailed(fmt::format("{}: cannot be read: {}", shown, error.reason));
  }
}

}  // namespace vehicle
