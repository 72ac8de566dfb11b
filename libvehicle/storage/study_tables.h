#pragma once

#include <string>
#include <vector>

#include "libvehicle/storage/sqlite_handle.h"
#include "libvehicle/storage/study_record.h"

namespace vehicle {

// The tables of a study database. Private to this room.

/// Marks the file as ours ("VHST") and names the format of its tables.
inline constexpr int kStudyApplication = 0x56485354;
///   1  a design that is done has every value
///   2  it may lack some (NULL), which a program that knows format 1 would show as 0; warnings of each design
inline constexpr int kStudyFormat = 2;
inline constexpr int kOldestStudyFormat = 1;  // that can be read

/// Makes and fills all tables but the designs.
/// @throws SqliteError
void writeStudyTables(SqliteConnection& connection, const StudyRecord& record);

/// Whether the file holds a study that can be read; a text that says why not, else "".
/// @throws SqliteError
[[nodiscard]] std::string whyNoStudy(SqliteConnection& connection);

/// Whether designs of this program may be added; a text that says why not, else "".
/// @throws SqliteError
[[nodiscard]] std::string whyOnlyShown(SqliteConnection& connection);

/// @throws SqliteError
[[nodiscard]] StudyRecord readStudyTables(SqliteConnection& connection);

}  // namespace vehicle
