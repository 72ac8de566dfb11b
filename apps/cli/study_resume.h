#pragma once

#include <string>

#include "libvehicle/project/study_work.h"


namespace vehicle::cli {

/// The program as databases name it.
inline constexpr const char* kProgram = "vehicle " VEHICLE_VERSION;

/// Before a study goes on: whether the database holds its designs. Of another study one line says which it is; of the
/// same study with other files, every line that has changed, at its place.
/// @param study  the study's file, as the command line names it
/// @throws InvalidInput  another study or other files; a database that is damaged or none
void requireOwnDatabase(const std::string& database, const std::string& study, const StudyWork& work);

/// The study that a database keeps. Problems of its files, which a stricter program may find, are placed in it.
/// @throws InvalidInput
[[nodiscard]] StudyWork restoredFrom(const StudyRecord& record, const std::string& database);

}  // namespace vehicle::cli
