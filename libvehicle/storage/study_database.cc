#include "libvehicle/storage/study_database.h"

#include <unistd.h>

#include <cerrno>
#include <set>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/storage/atomic_file.h"
#include "libvehicle/storage/database_files.h"
#include "libvehicle/storage/file_identity.h"
#include "libvehicle/storage/output_kind.h"
#include "libvehicle/storage/study_changes.h"
#include "libvehicle/storage/study_open.h"
#include "libvehicle/storage/study_refusal.h"
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
/// @throws InvalidInput, SqliteError
StudyRecord recordIn(SqliteConnection& connection, const std::string& shown) {
  const std::string why = whyNoStudy(connection);
  if (!why.empty()) refuseDatabase(shown, why, "name a database that this program's `vehicle study --output` wrote");
  return readStudyTables(connection);
}

/// SQLite would play the log of a study that has been removed into the next one of its name.
void removeLogsOf(const fs::path& path) {
  for (const std::string_view ending : kCompanionEndings) {
    if (ending == "-lock") continue;  // held by us
    const fs::path log = companionOf(path, ending);
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
  refuseDatabase(shown, fmt::format("is damaged ({})", finding), "go on with a copy, or begin a new study");
}

/// A file of SQLite's under a passing name, gone with all that SQLite puts beside it unless it has been renamed.
class PassingDatabase {
 public:
  explicit PassingDatabase(fs::path path) : path_(std::move(path)) { remove(); }
  ~PassingDatabase() { remove(); }
  PassingDatabase(const PassingDatabase&) = delete;
  PassingDatabase& operator=(const PassingDatabase&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  void remove() const {
    std::error_code ignored;
    fs::remove(path_, ignored);
    for (const std::string_view ending : kCompanionEndings) fs::remove(companionOf(path_, ending), ignored);
  }
  fs::path path_;
};

/// Builds the file under another name, so that it is there at once and whole.
void writeNewFile(const fs::path& path, const std::string& shown, const StudyRecord& record) {
  fs::path name = path;
  name += fmt::format(".{}.vehicle-tmp", ::getpid());
  const PassingDatabase temporary(name);
  try {
    SqliteConnection connection(name.string(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
    // Nobody knows the file before it has its name: no journal is needed to undo anything.
    connection.run(
        fmt::format("PRAGMA page_size={}; PRAGMA journal_mode=OFF; PRAGMA synchronous=FULL; BEGIN;", kPageBytes));
    writeStudyTables(connection, record);
    connection.run("COMMIT; PRAGMA journal_mode=WAL;");
  } catch (const SqliteError& error) {
    throw RunFailed(fmt::format("{}: cannot be written: {}; its folder must exist, be writable and have room", shown,
                                error.reason));
  }
  removeLogsOf(path);
  if (::rename(name.c_str(), path.c_str()) != 0) {
    throw RunFailed(fmt::format("{}: cannot be renamed into place: {}", shown, std::generic_category().message(errno)));
  }
  flushFolderOf(path);
}

/// Moves what stands in the log of a database that is to be replaced into the file, so that a crash before the new one
/// has its name leaves the old one whole. One that is damaged has nothing to be kept.
/// @throws RunFailed  another program is writing it
void settleOld(const fs::path& path, const std::string& shown) {
  try {
    SqliteConnection old(path.string(), SQLITE_OPEN_READWRITE);
    old.run("BEGIN IMMEDIATE; ROLLBACK; PRAGMA wal_checkpoint(TRUNCATE);");
  } catch (const SqliteError& error) {
    const int code = error.code & 0xff;
    if (code != SQLITE_BUSY && code != SQLITE_LOCKED) return;
    throw RunFailed(fmt::format("{}: another process is writing it; wait for its end", shown));
  }
}

}  // namespace

StudyDatabase::StudyDatabase(std::unique_ptr<Open> open) : open_(std::move(open)) {}
StudyDatabase::StudyDatabase(StudyDatabase&&) noexcept = default;
StudyDatabase::~StudyDatabase() = default;

const StudyRecord& StudyDatabase::record() const { return open_->record; }

StudyDatabase StudyDatabase::forWriting(const fs::path& path, const std::string& shown,
                                        std::unique_ptr<FileLock> lock) {
  auto open = std::make_unique<Open>();
  open->shown = shown;
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
    open->insert = std::make_unique<SqliteStatement>(*open->connection, insert + ",?)");
  } catch (const SqliteError& error) {
    refuseReading(open->shown, error);
  }
  return StudyDatabase(std::move(open));
}

StudyDatabase StudyDatabase::create(const fs::path& path, const StudyRecord& record) {
  requireDistinct(record);
  requireRoom(record);
  const fs::path target = followed(path);
  auto lock = std::make_unique<FileLock>(target);
  std::error_code ignored;
  if (fs::exists(target, ignored) && !(fs::is_regular_file(target, ignored) && fs::is_empty(target, ignored))) {
    throw RunFailed(fmt::format("{}: exists already; go on with it, remove it, or name another file", path.string()));
  }
  writeNewFile(target, path.string(), record);
  return forWriting(target, path.string(), std::move(lock));
}

StudyDatabase StudyDatabase::replace(const fs::path& path, const StudyRecord& record) {
  if (!isOurs(path, OutputKind::kDatabase)) return create(path, record);
  requireDistinct(record);
  requireRoom(record);
  const fs::path target = followed(path);
  auto lock = std::make_unique<FileLock>(target);
  settleOld(target, path.string());
  writeNewFile(target, path.string(), record);
  return forWriting(target, path.string(), std::move(lock));
}

StudyDatabase StudyDatabase::resume(const fs::path& path, const StudyRecord& now) {
  requireDatabaseFile(path);
  const fs::path target = followed(path);
  StudyDatabase database = forWriting(target, path.string(), std::make_unique<FileLock>(target));
  if (ProblemList changes = changesOf(database.record(), now, path.string()); !changes.empty()) {
    throw InvalidInput(std::move(changes));
  }
  try {
    requireSound(*database.open_->connection, path.string());
  } catch (const SqliteError& error) {
    refuseReading(path.string(), error);
  }
  return database;
}

StudyDatabase StudyDatabase::read(const fs::path& path) {
  requireDatabaseFile(path);
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
    const fs::path log = companionOf(path, "-wal");
    std::error_code ignored;
    if ((code != SQLITE_CANTOPEN && code != SQLITE_READONLY) || fs::exists(log, ignored))
      refuseReading(open->shown, error);
    try {
      open->connection = std::make_unique<SqliteConnection>(immutableUri(path), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
      open->record = recordIn(*open->connection, open->shown);
    } catch (const SqliteError& second) {
      refuseReading(open->shown, second);
    }
  }
  return StudyDatabase(std::move(open));
}

}  // namespace vehicle
