#include "libvehicle/storage/sqlite_handle.h"

#include <filesystem>
#include <system_error>

namespace vehicle {

namespace {

/// SQLite may be built to read "file:a.sqlite" as a URI and reads ":memory:" as no file at all; an absolute path is
/// neither.
std::string nameFor(const std::string& path, int flags) {
  return (flags & SQLITE_OPEN_URI) != 0 ? path : std::filesystem::absolute(path).string();
}

}  // namespace

SqliteConnection::SqliteConnection(const std::string& path, int flags) {
  const std::string name = nameFor(path, flags);
  const int code = sqlite3_open_v2(name.c_str(), &handle_, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  if (code != SQLITE_OK) {
    SqliteError error{code, sqlite3_errstr(code)};
    if (handle_ != nullptr) {
      if (const int system = sqlite3_system_errno(handle_); system != 0) {
        error.reason = std::generic_category().message(system);
      }
    }
    sqlite3_close_v2(handle_);
    throw error;
  }
  sqlite3_extended_result_codes(handle_, 1);
}

void SqliteConnection::fail(int code) const {
  SqliteError error{sqlite3_extended_errcode(handle_), sqlite3_errmsg(handle_)};
  if (error.code == SQLITE_OK) error.code = code;
  const int system = sqlite3_system_errno(handle_);
  if ((error.code & 0xff) == SQLITE_IOERR && system != 0) {
    error.reason += " (" + std::generic_category().message(system) + ")";
  }
  throw error;
}

void SqliteConnection::run(const std::string& sql) {
  const int code = sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(code);
}

SqliteStatement::SqliteStatement(SqliteConnection& connection, const std::string& sql) : connection_(connection) {
  check(sqlite3_prepare_v3(connection.get(), sql.c_str(), static_cast<int>(sql.size()), SQLITE_PREPARE_PERSISTENT,
                           &handle_, nullptr));
}

bool SqliteStatement::step() {
  const int code = sqlite3_step(handle_);
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  const SqliteConnection& connection = connection_;
  sqlite3_reset(handle_);
  connection.fail(code);
}

std::string_view SqliteStatement::text(int column) const {
  const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(handle_, column));
  if (bytes == nullptr) return {};
  return {bytes, static_cast<std::size_t>(sqlite3_column_bytes(handle_, column))};
}

}  // namespace vehicle
