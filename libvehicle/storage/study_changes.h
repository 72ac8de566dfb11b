#pragma once

#include <string>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/storage/study_record.h"

namespace vehicle {

/// Why a database may not go on with the study as it is now; empty if it may. One problem for each line of an input
/// file that has changed since (20 of a file at most), at its place in the file as it is now, one for each file that
/// has come or gone (a file is known by its name, else by its text); then, at the database, that it holds the study as
/// it was, or that another program has begun it.
/// Places of input files are named as the records name them.
/// @param shown  the database, as messages call it
[[nodiscard]] ProblemList changesOf(const StudyRecord& before, const StudyRecord& now, const std::string& shown);

}  // namespace vehicle
