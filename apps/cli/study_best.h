#pragma once

#include <string>
#include <vector>

#include "libvehicle/project/study_work.h"
#include "libvehicle/study/summary.h"

namespace vehicle::cli {

/// Makes the folder of --write-best and asks whether files may be written there.
/// @throws RunFailed
void requireFolder(const std::string& folder);

/// Writes the best designs of each objective as vehicle files: FOLDER/OBJECTIVE-RANK.xml. Without objectives these are
/// the named designs, FOLDER/NAME.xml. A train is written as its own file and those of its vehicles,
/// FOLDER/NAME-UNIT.xml.
/// @returns the files written
/// @throws std::invalid_argument  a train's file cannot hold a design
/// @throws RunFailed              a file cannot be written
std::vector<std::string> writeBest(const std::string& folder, const StudySummary& summary, const StudyWork& work);

}  // namespace vehicle::cli
