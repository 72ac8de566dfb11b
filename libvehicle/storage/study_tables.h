#pragma once

#include <string>
#include <vector>

#include "libvehicle/storage/sqlite_handle.h"
#include "libvehicle/storage/study_record.h"

namespace vehicle {

// The tables of a study database. Private to this room.

/// Marks the file as ours ("VHST") and names the format of its tables.
inline constexpr int kStudyApplication = 0x56485354;
inline constexpr int kStudyFormat = 1;

/// Makes and fills all tables but the designs.
/// @throws SqliteError
void writeStudyTables(SqliteConnection& connection, const StudyRecord& record);

/// Whether the file holds a study of this format; a text that says why not, else "".
/// @throws SqliteError
[[nodiscard]] std::string whyNoStudy(SqliteConnection& connection);

/// @throws SqliteError
[[nodiscard]] StudyRecord readStudyTables(SqliteConnection& connection);

}  // namespace vehicle
