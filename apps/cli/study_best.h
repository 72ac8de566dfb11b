#pragma once

#include <string>
#include <vector>

#include "libvehicle/study/study_inputs.h"
#include "libvehicle/study/summary.h"

namespace vehicle::cli {

/// Writes the best designs of each objective as vehicle files: FOLDER/OBJECTIVE-RANK.xml. Without objectives these are the
/// named designs, FOLDER/NAME.xml. The folder is made if it is not there.
/// @returns the files written
/// @throws std::invalid_argument  the study's vehicle is a train
/// @throws RunFailed              a file cannot be written
std::vector<std::string> writeBest(const std::string& folder, const StudySummary& summary, const StudyInputs& inputs);

}  // namespace vehicle::cli
