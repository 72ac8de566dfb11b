#include "libvehicle/storage/study_database.h"

#include <unistd.h>

#include <cerrno>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/storage/atomic_file.h"
#include "libvehicle/storage/study_changes.h"
#include "libvehicle/storage/study_open.h"
#include "libvehicle/storage/study_tables.h"

namespace vehicle {

namespace fs = std::filesystem;

void StudyDatabase::Open::fail(const std::string& what, const SqliteError& error, const std::string& remedy) const {
  throw RunFailed(fmt::format("{}: {}: {}{}{}", shown, what, error.reason, remedy.empty() ? "" : "; ", remedy));
}

namespace {

// Measured on 10^6 rows of 30 numbers; docs/decisions.md has the figures.
constexpr int kPageBytes = 16384;
constexpr int kLogPages = 4096;  // of the write-ahead log before it is moved into the file: 64 MiB
constexpr int kCacheKib = 32 * 1024;
constexpr int kWaitForReaders = 5000;  // [ms]

void requireDistinct(const StudyRecord& record) {
  std::set<std::string> names;
  for (const std::vector<Channel>* list : {&record.parameters, &record.metrics}) {
    for (const Channel& each : *list) {
      if (!names.insert(each.name).second) {
        throw std::invalid_argument(fmt::format("StudyDatabase: the column \"{}\" stands there twice", each.name));
      }
    }
  }
}

void requireRoom(SqliteConnection& connection, const StudyRecord& record) {
  const std::size_t values = record.parameters.size() + record.metrics.size();
  const auto most = static_cast<std::size_t>(mostValues(connection));
  if (values <= most) return;
  ProblemList problems;
  const std::string file = record.inputs.empty() ? "" : record.inputs.front().name;
  problems.add({file, 0}, "",
               fmt::format("the study makes {} columns ({} parameters, {} metrics over all speeds and scenarios), at "
                           "most {} fit in a row",
                           values, record.parameters.size(), record.metrics.size(), most),
               "ask for fewer metrics or speeds, or make two studies");
  throw InvalidInput(std::move(problems));
}

/// name -> "file:name?immutable=1", with what a URI cannot hold escaped.
std::string immutableUri(const fs::path& path) {
  std::string uri = "file:";
  for (const char c : fs::absolute(path).string()) {
    if (c == '?' || c == '#' || c == '%') {
      uri += fmt::format("%{:02X}", static_cast<int>(c));
    } else {
      uri += c;
    }
  }
  return uri + "?immutable=1";
}

/// Asks for what a file must hold to be a study.
/// @throws RunFailed, SqliteError
StudyRecord recordIn(SqliteConnection& connection, const std::string& shown) {
  const std::string why = whyNoStudy(connection);
  if (!why.empty()) throw RunFailed(fmt::format("{}: {}", shown, why));
  return readStudyTables(connection);
}

[[noreturn]] void failOpening(const std::string& shown, const SqliteError& error) {
  if ((error.code & 0xff) == SQLITE_NOTADB) throw RunFailed(shown + ": holds no study: it is no SQLite file");
  if ((error.code & 0xff) == SQLITE_CORRUPT) {
    throw RunFailed(fmt::format("{}: is damaged ({}); go on with a copy, or begin a new study", shown, error.reason));
  }
  throw RunFailed(fmt::format("{}: cannot be opened: {}", shown, error.reason));
}

void requireFile(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_regular_file(status)) return;
  const char* why = !fs::exists(status)        ? "there is no such file"
                    : fs::is_directory(status) ? "it is a folder"
                                               : "it is a device or pipe";
  throw RunFailed(fmt::format("{}: cannot be opened: {}", path.string(), why));
}

/// SQLite would play the log of a study that has been removed into the next one of its name.
void removeLogsOf(const fs::path& path) {
  for (const char* ending : {"-wal", "-shm", "-journal"}) {
    fs::path log = path;
    log += ending;
    std::error_code error;
    fs::remove(log, error);
    if (error) throw RunFailed(fmt::format("{}: cannot be removed: {}", log.string(), error.message()));
  }
}

/// A file that a disk has damaged may read well for a while, and would take the designs to come into its damage.
/// Costs about 2 us a design.
void requireSound(SqliteConnection& connection, const std::string& shown) {
  SqliteStatement check(connection, "PRAGMA quick_check(1)");
  check.step();
  std::string_view finding = check.text(0);
  if (finding == "ok") return;
  finding.remove_prefix(finding.rfind('\n') + 1);  // above it stands which database
  throw RunFailed(fmt::format("{}: is damaged ({}); go on with a copy, or begin a new study", shown, finding));
}

/// Builds the file under another name, so that it is there at once and whole.
void writeNewFile(const fs::path& path, const StudyRecord& record) {
  const std::string shown = path.string();
  fs::path temporary = path;
  temporary += fmt::format(".{}.vehicle-tmp", ::getpid());
  std::error_code ignored;
  fs::remove(temporary, ignored);
  try {
    SqliteConnection connection(temporary.string(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
    requireRoom(connection, record);
    // Nobody knows the file before it has its name: no journal is needed to undo anything.
    connection.run(
        fmt::format("PRAGMA page_size={}; PRAGMA journal_mode=OFF; PRAGMA synchronous=FULL; BEGIN;", kPageBytes));
    writeStudyTables(connection, record);
    connection.run("COMMIT; PRAGMA journal_mode=WAL;");
  } catch (const SqliteError& error) {
    fs::remove(temporary, ignored);
    throw RunFailed(fmt::format("{}: cannot be written: {}; its folder must exist, be writable and have room", shown,
                                error.reason));
  } catch (...) {
    fs::remove(temporary, ignored);
    throw;
  }
  try {
    removeLogsOf(path);
  } catch (...) {
    fs::remove(temporary, ignored);
    throw;
  }
  if (::rename(temporary.c_str(), path.c_str()) != 0) {
    const std::string reason = std::generic_category().message(errno);
    fs::remove(temporary, ignored);
    throw RunFailed(fmt::format("{}: cannot be renamed into place: {}", shown, reason));
  }
  flushFolderOf(path);
}

}  // namespace

StudyDatabase::StudyDatabase(std::unique_ptr<Open> open) : open_(std::move(open)) {}
StudyDatabase::StudyDatabase(StudyDatabase&&) noexcept = default;
StudyDatabase::~StudyDatabase() = default;

const StudyRecord& StudyDatabase::record() const { return open_->record; }

StudyDatabase StudyDatabase::forWriting(const fs::path& path, std::unique_ptr<FileLock> lock) {
  auto open = std::make_unique<Open>();
  open->shown = path.string();
  open->lock = std::move(lock);
  if (::access(path.c_str(), W_OK) != 0) {
    throw RunFailed(fmt::format("{}: cannot be written: {}", open->shown, std::generic_category().message(errno)));
  }
  try {
    open->connection = std::make_unique<SqliteConnection>(path.string(), SQLITE_OPEN_READWRITE);
    sqlite3_busy_timeout(open->connection->get(), kWaitForReaders);
    open->record = recordIn(*open->connection, open->shown);
    if (const std::string why = whyOnlyShown(*open->connection); !why.empty()) {
      throw RunFailed(fmt::format("{}: {}", open->shown, why));
    }
    open->connection->run(fmt::format(
        "PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL; PRAGMA wal_autocheckpoint={}; PRAGMA cache_size=-{};",
        kLogPages, kCacheKib));
    std::string insert = "INSERT INTO designs VALUES(?,?,?";
    for (std::size_t i = 0; i < open->record.parameters.size() + open->record.metrics.size(); ++i) insert += ",?";
    open->insert = std::make_unique<SqliteStatement>(*open->connection, insert + ")");
  } catch (const SqliteError& error) {
    failOpening(open->shown, error);
  }
  return StudyDatabase(std::move(open));
}

StudyDatabase StudyDatabase::create(const fs::path& path, const StudyRecord& record) {
  requireDistinct(record);
  auto lock = std::make_unique<FileLock>(path);
  std::error_code ignored;
  if (fs::symlink_status(path, ignored).type() != fs::file_type::not_found) {
    throw RunFailed(fmt::format("{}: exists already; go on with it, remove it, or name another file", path.string()));
  }
  writeNewFile(path, record);
  return forWriting(path, std::move(lock));
}

StudyDatabase StudyDatabase::resume(const fs::path& path, const StudyRecord& now) {
  requireFile(path);
  StudyDatabase database = forWriting(path, std::make_unique<FileLock>(path));
  requireSameStudy(database.record(), now, path.string());
  try {
    requireSound(*database.open_->connection, path.string());
  } catch (const SqliteError& error) {
    failOpening(path.string(), error);
  }
  return database;
}

StudyDatabase StudyDatabase::read(const fs::path& path) {
  requireFile(path);
  auto open = std::make_unique<Open>();
  open->shown = path.string();
  try {
    // One that may write takes the log and its index away when it closes as the last; a reading one leaves them there.
    open->connection = std::make_unique<SqliteConnection>(path.string(), SQLITE_OPEN_READWRITE);
    open->connection->run("PRAGMA query_only=ON");
    sqlite3_busy_timeout(open->connection->get(), kWaitForReaders);
    open->record = recordIn(*open->connection, open->shown);
  } catch (const SqliteError& error) {
    // A folder that may not be written has no place for the index of the write-ahead log. Where no log is left over,
    // nobody is writing and the file alone is the whole study.
    const int code = error.code & 0xff;
    fs::path log = path;
    log += "-wal";
    std::error_code ignored;
    if ((code != SQLITE_CANTOPEN && code != SQLITE_READONLY) || fs::exists(log, ignored))
      failOpening(open->shown, error);
    try {
      open->connection = std::make_unique<SqliteConnection>(immutableUri(path), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
      open->record = recordIn(*open->connection, open->shown);
    } catch (const SqliteError& second) {
      failOpening(open->shown, second);
    }
  }
  return StudyDatabase(std::move(open));
}

}  // namespace vehicle
