#pragma once

#include "apps/cli/cli11.h"
#include "apps/cli/study_work.h"
#include "libvehicle/project/study_work.h"

namespace vehicle::cli {

// What the options of `study` ask of each other, of the study and of the files to be written; all throw
// std::invalid_argument for a command line that is wrong.

/// What shows before any file is read: a file or option that is missing, or has no effect beside the others.
void requireStudyOptions(const CLI::App& command, const StudyOptions& options);

/// What has no effect on this study: --best without objectives, --write-best without anything to be written.
void requireUsedByStudy(const CLI::App& command, const Study& study);

/// Protects every file that the study was read from, or the database that is shown, and claims every output.
/// @throws RunFailed  where the system does not let a file be written
void claimOutputs(OutputGuard& guard, const CLI::App& command, const StudyOptions& options, const StudyWork& work);

}  // namespace vehicle::cli
