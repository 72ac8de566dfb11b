#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include <sqlite3.h>

namespace vehicle {

// SQLite's handles with one owner each. Private to this room.

struct SqliteError {
  int code = 0;        // extended result code
  std::string reason;  // e.g. "database or disk is full", with the system's reason where there is one
};

class SqliteConnection {
 public:
  /// @param path   of the file; with SQLITE_OPEN_URI among the flags a URI
  /// @param flags  SQLITE_OPEN_...
  /// @throws SqliteError
  SqliteConnection(const std::string& path, int flags);
  ~SqliteConnection() { sqlite3_close_v2(handle_); }
  SqliteConnection(const SqliteConnection&) = delete;
  SqliteConnection& operator=(const SqliteConnection&) = delete;

  /// Runs statements without results.
  /// @throws SqliteError
  void run(const std::string& sql);
  [[noreturn]] void fail(int code) const;
  [[nodiscard]] sqlite3* get() const { return handle_; }

 private:
  sqlite3* handle_ = nullptr;
};

class SqliteStatement {
 public:
  /// @throws SqliteError
  SqliteStatement(SqliteConnection& connection, const std::string& sql);
  ~SqliteStatement() { sqlite3_finalize(handle_); }
  SqliteStatement(const SqliteStatement&) = delete;
  SqliteStatement& operator=(const SqliteStatement&) = delete;

  /// Places count from 1. A text must outlive the next step.
  void bind(int place, std::int64_t value) { check(sqlite3_bind_int64(handle_, place, value)); }
  void bind(int place, double value) { check(sqlite3_bind_double(handle_, place, value)); }
  void bind(int place, std::string_view text) {
    check(sqlite3_bind_text(handle_, place, text.empty() ? "" : text.data(), static_cast<int>(text.size()),
                            SQLITE_STATIC));
  }
  void bindNothing(int place) { check(sqlite3_bind_null(handle_, place)); }

  /// @returns true where there is a row
  /// @throws SqliteError
  bool step();
  /// Runs a statement without result and makes it ready for the next.
  void runOnce() {
    step();
    reset();
  }
  void reset() { sqlite3_reset(handle_); }

  /// Columns of the row at hand count from 0.
  [[nodiscard]] std::int64_t integer(int column) const { return sqlite3_column_int64(handle_, column); }
  [[nodiscard]] double numberOrNan(int column) const {  // NaN: NULL
    if (sqlite3_column_type(handle_, column) == SQLITE_NULL) return std::numeric_limits<double>::quiet_NaN();
    return sqlite3_column_double(handle_, column);
  }
  [[nodiscard]] std::string_view text(int column) const;
  [[nodiscard]] int columns() const { return sqlite3_column_count(handle_); }

 private:
  void check(int code) const {
    if (code != SQLITE_OK) connection_.fail(code);
  }

  SqliteConnection& connection_;
  sqlite3_stmt* handle_ = nullptr;
};

}  // namespace vehicle
