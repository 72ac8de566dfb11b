#pragma once

#include <string>
#include <vector>

#include "apps/cli/options.h"
#include "libvehicle/storage/output_guard.h"

namespace vehicle::cli {

struct StudyOptions {
  std::string study;     // file, or "show"
  std::string shown;     // database after "show"
  std::string database;  // --output
  std::vector<std::string> settings;  // --set
  bool resume = false;
  Overwrite overwrite = Overwrite::kOwnFiles;
  int jobs = 0;  // 0: every processing unit
  int best = 5;
  std::string best_folder;
  std::string csv;
  CommonOptions common;
};

/// Evaluates what is missing, then shows the whole study. On a rank of an MPI job that does not lead: only evaluates.
/// @param command  which options were given
/// @returns exit status
int runStudyFile(const StudyOptions& options, const CLI::App& command);

/// Shows what a database holds.
int showStudy(const StudyOptions& options, const CLI::App& command);

}  // namespace vehicle::cli
