#pragma once

#include <string>

#include "apps/cli/options.h"

namespace vehicle::cli {

struct StudyOptions {
  std::string study;     // file, or "show"
  std::string shown;     // database after "show"
  std::string database;  // --output
  bool resume = false;
  int jobs = 0;  // 0: every processing unit
  int best = 5;
  std::string best_folder;
  std::string csv;
  CommonOptions common;
};

/// Evaluates what is missing, then shows the whole study. On a rank of an MPI job that does not lead: only evaluates.
/// @returns exit status
int runStudyFile(const StudyOptions& options);

/// Shows what a database holds.
int showStudy(const StudyOptions& options);

}  // namespace vehicle::cli
