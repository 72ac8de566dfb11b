#pragma once

#include <memory>
#include <string>

#include "libvehicle/storage/file_lock.h"
#include "libvehicle/storage/sqlite_handle.h"
#include "libvehicle/storage/study_database.h"

namespace vehicle {

/// An open study. Members close from the last to the first: the lock goes after the connection. Private to this room.
struct StudyDatabase::Open {
  std::string shown;               // the path as the caller gave it, for messages
  std::unique_ptr<FileLock> lock;  // while writing
  std::unique_ptr<SqliteConnection> connection;
  StudyRecord record;
  std::unique_ptr<SqliteStatement> insert;

  /// @throws RunFailed
  [[noreturn]] void fail(const std::string& what, const SqliteError& error, const std::string& remedy = "") const;
};

}  // namespace vehicle
