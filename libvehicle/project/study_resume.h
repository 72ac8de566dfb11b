#pragma once

#include <string>

#include "libvehicle/project/study_work.h"

namespace vehicle {

/// Before a study goes on: whether the database holds its designs. Of another study one line says which it is; of the
/// same study with other files, every line that has changed, at its place.
/// @param study    the study's file, as the user names it
/// @param program  name and version, as the study would be stored by now
/// @throws InvalidInput  another study or other files; a database that is damaged or none
void requireOwnDatabase(const std::string& database, const std::string& study, const StudyWork& work,
                        const std::string& program);

/// The study that a database keeps. Problems of its files, which a stricter program may find, are placed in it.
/// @throws InvalidInput
[[nodiscard]] StudyWork restoredFrom(const StudyRecord& record, const std::string& database);

}  // namespace vehicle
