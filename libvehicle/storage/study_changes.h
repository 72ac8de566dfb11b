#pragma once

#include <string>

#include "libvehicle/storage/study_record.h"

namespace vehicle {

/// Whether a database may go on with the study as it is now. Private to this room.
/// @param shown  the database, as messages call it
/// @throws InvalidInput  input files have changed: one problem a line, 20 a file at most, at its place in the file as
///                       it is now
/// @throws RunFailed     another program has begun it, or it has other columns
void requireSameStudy(const StudyRecord& before, const StudyRecord& now, const std::string& shown);

}  // namespace vehicle
